// A clipped polygon after the snap, as a fan of triangles. docs/manual/geometry.md, "Window
// coordinates". Does not clip, cull or draw.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace gw {

using SnappedPoint = std::array<std::int64_t, 2>;

/// Twice the signed area of a, b, c; > 0 is counter-clockwise with y up.
constexpr std::int64_t area2(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/// Piece k = 1 .. n - 2 of a polygon of n corners has the corners first, first + k and
/// first + k + 1, modulo n.
struct Fan {
    std::int64_t area2 = 0;  ///< of the polygon: the sum over its pieces
    /// the first corner whose fan has no piece that the snap turned over; 0 if there is none
    std::size_t first = 0;
};

/// A piece whose area has the opposite sign of the polygon's makes no fragments.
Fan fan_of(std::span<const SnappedPoint> corners);

}  // namespace gw
