#include "gw/reference/plane_equation.h"

#include <algorithm>

namespace gw::reference {
namespace {

int128 value_at(const PlaneEquation& p, int x, int y) {
    const std::int64_t half = std::int64_t{1} << (p.subpixel_bits - 1);
    const std::int64_t px = (std::int64_t{x} << p.subpixel_bits) + half,
                       py = (std::int64_t{y} << p.subpixel_bits) + half;
    const int128 step = (p.gx * (px - p.x0) + p.gy * (py - p.y0)) >> p.subpixel_bits;
    return ((int128{p.a0} << 16) + (1 << 15) + step) >> 16;
}

}  // namespace

std::int64_t PlaneEquation::at(int x, int y) const {
    return static_cast<std::int64_t>(value_at(*this, x, y));
}

std::int64_t PlaneEquation::limited_at(int x, int y) const {
    return static_cast<std::int64_t>(std::clamp<int128>(value_at(*this, x, y), low, high));
}

PlaneEquation plane_through(const SnappedTriangle& t, const std::array<std::int64_t, 3>& a) {
    const int128 dx1 = t.x[1] - t.x[0], dy1 = t.y[1] - t.y[0], dx2 = t.x[2] - t.x[0],
                 dy2 = t.y[2] - t.y[0];
    const int128 da1 = a[1] - a[0], da2 = a[2] - a[0];
    const int128 one = int128{1} << (16 + t.subpixel_bits);
    return {divide_round_even((da1 * dy2 - da2 * dy1) * one, t.area2),
            divide_round_even((da2 * dx1 - da1 * dx2) * one, t.area2),
            a[0],
            t.x[0],
            t.y[0],
            t.subpixel_bits,
            std::min({a[0], a[1], a[2]}),
            std::max({a[0], a[1], a[2]})};
}

PlaneEquation plane_along(const SnappedLine& l, std::int64_t a_first, std::int64_t a_second) {
    const std::int64_t d = l.x_major ? l.x[1] - l.x[0] : l.y[1] - l.y[0];
    const std::size_t low = d > 0 ? 0 : 1;
    const std::int64_t a0 = d > 0 ? a_first : a_second, a1 = d > 0 ? a_second : a_first;
    const int128 g =
        divide_round_even(int128{a1 - a0} * (int128{1} << (16 + l.subpixel_bits)), d > 0 ? d : -d);
    PlaneEquation p{
        0, 0, a0, l.x[low], l.y[low], l.subpixel_bits, std::min(a0, a1), std::max(a0, a1)};
    (l.x_major ? p.gx : p.gy) = g;
    return p;
}

PlaneEquation moved(PlaneEquation p, const JitterState& by) {
    p.x0 += by.x;
    p.y0 += by.y;
    return p;
}

PlaneEquation plane_constant(std::int64_t a, int subpixel_bits) {
    return {0, 0, a, 0, 0, subpixel_bits, a, a};
}

}  // namespace gw::reference
