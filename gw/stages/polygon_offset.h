// The polygon offset. docs/manual/rasterization.md, "Planes". Does not make the depth plane.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/state.h"

#include <algorithm>
#include <cstdint>

namespace gw {

/// The larger gradient of a depth plane, with 16 fraction bits, at most 2^62.
inline double offset_slope(int128 gx, int128 gy) {
    const auto steep = [](int128 v) { return v < 0 ? -v : v; };
    return double(std::min(std::max(steep(gx), steep(gy)), int128{1} << 62));
}

/// rne(factor m / 2^16) + rne(units), within one more than the depth plane's range.
inline std::int64_t depth_offset(const PolygonOffsetState& offset, double m, int depth_bits) {
    const double limit = double(max_of_bits(depth_bits)) + 1;
    return to_integer(round_even(double(offset.factor) * m / 65536) + round_even(offset.units),
                      -limit, limit);
}

/// Whether the outline of a polygon is offset.
constexpr bool offsets_outline(const PolygonOffsetState& offset, PolygonMode mode) {
    return (mode == PolygonMode::Line && offset.lines) ||
           (mode == PolygonMode::Point && offset.points);
}

}  // namespace gw
