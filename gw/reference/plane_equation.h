// The plane of an interpolated value, with correctly rounded integer gradients. Closed form and
// increments agree. docs/manual/rasterization.md, "Planes". [L8]: dz/dx = -n_x / n_z. Does not know
// the meaning of the value.
#pragma once

#include "gw/reference/coverage.h"

#include <cstdint>

namespace gw::reference {

/// V(x, y) = (a0 * 2^16 + 2^15 + floor((gx (PX - x0) + gy (PY - y0)) / 2^s)) >> 16, where (PX, PY)
/// is the centre of pixel x, y.
struct PlaneEquation {
    int128 gx = 0, gy = 0;  ///< per pixel, 16 fraction bits
    std::int64_t a0 = 0;    ///< value at (x0, y0)
    std::int64_t x0 = 0, y0 = 0;
    int subpixel_bits = 3;
    std::int64_t low = 0, high = 0;  ///< the least and greatest value at a corner

    std::int64_t at(int x, int y) const;
    /// The value at a pixel outside the primitive: limited to those of the corners.
    std::int64_t limited_at(int x, int y) const;
};

/// Through the values a of the triangle's canonical vertices.
PlaneEquation plane_through(const SnappedTriangle& triangle, const std::array<std::int64_t, 3>& a);
/// Along a line's major axis, from the end with the smaller major coordinate.
PlaneEquation plane_along(const SnappedLine& line, std::int64_t a_first, std::int64_t a_second);
/// That of the primitive after a move, in sub-pixels.
PlaneEquation moved(PlaneEquation p, const JitterState& by);
/// The same value everywhere.
PlaneEquation plane_constant(std::int64_t a, int subpixel_bits);

}  // namespace gw::reference
