// z over a triangle from its plane, and by increments. [L8] dz/dx = -n_x / n_z, with the machine's
// rounding: docs/manual.md, "Planes". Does not compare depths.
#pragma once

#include "hiddensurface/model/grid.h"

#include <array>

namespace gw::hiddensurface {

__extension__ using int128 = __int128;
constexpr int sign(int128 v) { return v < 0 ? -1 : v > 0 ? 1 : 0; }

/// z = floor(value / 2^16), kept in 0 .. largest; value(x, y) = a0 2^16 + 2^15 + floor((gx (PX -
/// x0) + gy (PY - y0)) / 2^s) at the centre (PX, PY) of pixel x, y.
struct DepthPlane {
    /// Per pixel, 16 fraction bits: -n_x / n_z and -n_y / n_z to nearest, ties to even.
    int128 gx = 0, gy = 0;
    std::int64_t a0 = 0, x0 = 0, y0 = 0;
    int subpixel_bits = 3;
    std::int64_t largest = 0;  ///< of the depth plane

    /// The closed form.
    int128 value(int x, int y) const;
    /// A value as the depth plane holds it.
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

/// Along a row, pixel by pixel: one addition each. [L8]
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
