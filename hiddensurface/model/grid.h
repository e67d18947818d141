// The machine's window grid, on which all algorithms decide: snapped points, rows of pixels.
// Does not draw.
#pragma once

#include "gw/base/types.h"

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

/// Corners in order; z as on the grid, x and y too, but cuts may lie between.
using Loop = std::vector<dvec3>;

}  // namespace gw::hiddensurface
