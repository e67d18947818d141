// Coverage and planes in exact integer arithmetic, formulated independently of the machine. A
// point, moved by an infinitesimal, is inside by the number of crossings of a half-line; planes are
// sums with barycentric coordinates. Does not use any function of gw/.
#pragma once

#include <array>
#include <cstdint>

namespace gw::test {

__extension__ using Int = __int128;

/// A corner on the sub-pixel grid, in units of 2^-s pixel.
struct GridPoint {
    std::int64_t x = 0, y = 0;
    bool operator==(const GridPoint&) const = default;
};
using GridTriangle = std::array<GridPoint, 3>;

inline Int cross(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return Int{b.x - a.x} * (c.y - a.y) - Int{b.y - a.y} * (c.x - a.x);
}

/// Whether p + (e, -e^2) lies inside, e infinitely small: then a left or top side owns its points.
/// Counts crossings with the half-line to the right. e = 2^-24 of a unit is small enough for sides
/// of up to 2^23 units.
template <std::size_t n>
bool covers(const std::array<GridPoint, n>& polygon, const GridPoint& p) {
    constexpr int e = 24;
    const Int px = (Int{p.x} << (2 * e)) + (Int{1} << e), py = (Int{p.y} << (2 * e)) - 1;
    bool inside = false;
    for (std::size_t i = 0; i < n; ++i) {
        const GridPoint &a = polygon[i], &b = polygon[(i + 1) % n];
        const Int ay = Int{a.y} << (2 * e), by = Int{b.y} << (2 * e);
        if ((ay > py) == (by > py)) continue;
        // x of the side at py, to the right of px? a.x + (py - ay) (b.x - a.x) / (by - ay),
        // multiplied out.
        const Int left = (px - (Int{a.x} << (2 * e))) * (b.y - a.y),
                  right = (py - ay) * (b.x - a.x);
        if (b.y > a.y ? left < right : left > right) inside = !inside;
    }
    return inside;
}

/// Floor of a / b, b > 0.
inline Int floor_of(Int a, Int b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Nearest integer to a / b, b > 0, ties to even.
inline Int nearest_even(Int a, Int b) {
    const Int doubled = floor_of(2 * a + b, 2 * b);  // floor(a / b + 1/2)
    const bool tie = floor_of(2 * a + b, 2 * b) * 2 * b == 2 * a + b;
    return tie && doubled % 2 != 0 ? doubled - 1 : doubled;
}

/// n / d with d > 0.
struct Rational {
    Int n = 0, d = 1;
};

/// The exact value at p of the plane through the corners' values: the sum of a_i times its
/// barycentric coordinate.
inline Rational exact_value(const GridTriangle& t, const std::array<std::int64_t, 3>& a,
                            const GridPoint& p) {
    const Int d = cross(t[0], t[1], t[2]);
    const Int n =
        a[0] * cross(p, t[1], t[2]) + a[1] * cross(t[0], p, t[2]) + a[2] * cross(t[0], t[1], p);
    return d < 0 ? Rational{-n, -d} : Rational{n, d};
}

/// The manual's value by its definition: from the corner with the smallest (y, x), with gradients
/// per pixel of 16 fraction bits, each the nearest to the rational.
inline std::int64_t manual_value(const GridTriangle& t, const std::array<std::int64_t, 3>& a,
                                 const GridPoint& p, int s) {
    const Int d = cross(t[0], t[1], t[2]), sign = d < 0 ? -1 : 1, one = Int{1} << (16 + s);
    Int x = 0, y = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const GridPoint &next = t[(i + 1) % 3], &last = t[(i + 2) % 3];
        x += a[i] * Int{next.y - last.y};
        y += a[i] * Int{last.x - next.x};
    }
    const Int gx = nearest_even(sign * x * one, sign * d),
              gy = nearest_even(sign * y * one, sign * d);
    std::size_t first = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (t[i].y < t[first].y || (t[i].y == t[first].y && t[i].x < t[first].x)) first = i;
    const Int move = floor_of(gx * (p.x - t[first].x) + gy * (p.y - t[first].y), Int{1} << s);
    return std::int64_t(floor_of((Int{a[first]} << 16) + (1 << 15) + move, 1 << 16));
}

}  // namespace gw::test
