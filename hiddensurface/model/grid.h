// The machine's window grid, on which all algorithms decide: snapped points, rows of pixels, planes
// of depth. Does not draw.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw::hiddensurface {

/// A snapped vertex: x, y in 1/2^subpixel_bits of a pixel, z in units of the depth plane (smaller
/// is nearer).
struct GridPoint {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const GridPoint&) const = default;
};

/// Above 0: r lies to the left of p -> q in the window. Twice the area of the three.
constexpr std::int64_t turn(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}
inline dvec3 to_dvec3(const GridPoint& p) { return {double(p.x), double(p.y), double(p.z)}; }

/// Pixels x0 .. x1 - 1 of row y, bottom row 0.
struct Run {
    int y = 0, x0 = 0, x1 = 0;
    bool operator==(const Run&) const = default;
};

/// The centre of a pixel on the grid.
constexpr std::int64_t center(int pixel, int subpixel_bits) {
    return (std::int64_t{pixel} << subpixel_bits) + (std::int64_t{1} << (subpixel_bits - 1));
}

/// Corners in order, in units of the grid; corners that a cut made are not snapped.
using Loop = std::vector<dvec3>;

// Depth planes [L8]: z over a triangle, dz/dx = -n_x / n_z, with the machine's rounding:
// docs/manual.md, "Planes".

__extension__ using int128 = __int128;
constexpr int sign(int128 v) { return v < 0 ? -1 : v > 0 ? 1 : 0; }

/// z = floor(value / 2^16), clamped to 0 .. largest. At the centre (PX, PY) of pixel x, y,
/// value(x, y) = a0 2^16 + 2^15 + floor((gx (PX - x0) + gy (PY - y0)) / 2^s).
struct DepthPlane {
    /// Per pixel, 16 fraction bits: -n_x / n_z and -n_y / n_z to nearest, ties to even.
    int128 gx = 0, gy = 0;
    std::int64_t a0 = 0, x0 = 0, y0 = 0;
    int subpixel_bits = 3;
    std::int64_t largest = 0;  ///< of the depth plane

    /// The closed form.
    int128 value(int x, int y) const;
    /// A value as the depth plane stores it.
    std::int64_t depth(int128 value) const;
    std::int64_t at(int x, int y) const { return depth(value(x, y)); }
};

/// Corners in any order, not on one line.
DepthPlane depth_plane(const std::array<GridPoint, 3>& triangle, int subpixel_bits, int depth_bits);

/// Sign of z_a - z_b at the centre of pixel x, y, on the exact planes through the corners: no
/// rounding at all.
int exact_order(const std::array<GridPoint, 3>& a, const std::array<GridPoint, 3>& b, int x, int y,
                int subpixel_bits);

/// Whether a point is in the triangle's plane, exactly.
bool is_on_plane(const std::array<GridPoint, 3>& triangle, const GridPoint& p);

/// Walks along a row with one addition for each pixel. [L8]
class DepthWalk {
public:
    DepthWalk(const DepthPlane& plane, int x, int y) : plane_(plane), value_(plane.value(x, y)) {}
    std::int64_t z() const { return plane_.depth(value_); }
    void right() { value_ += plane_.gx; }

private:
    const DepthPlane& plane_;
    int128 value_;
};

}  // namespace gw::hiddensurface
