// A clipped polygon after the snap, as a fan of triangles. docs/manual.md, "Window coordinates".
// Does not clip, cull or draw.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace gw {

using SnappedPoint = std::array<std::int64_t, 2>;

/// Twice the signed area of a, b, c, > 0 where counter-clockwise with y up.
constexpr std::int64_t area2(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/// The pieces are first, first + k, first + k + 1 (modulo the number of corners), k = 1 .. corners
/// - 2.
struct Fan {
    std::int64_t area2 = 0;  ///< of the polygon: the sum of its pieces'
    /// the first corner from which the snap has turned no piece over; else 0
    std::size_t first = 0;
};

/// A piece whose area has another sign than the polygon's makes no fragments.
Fan fan_of(std::span<const SnappedPoint> corners);

}  // namespace gw
