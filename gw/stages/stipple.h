// Steps along a line, for its stipple. docs/manual/rasterization.md, "Stipple". Does not cover
// pixels.
#pragma once

#include "gw/state.h"

#include <cstdint>

namespace gw {

/// The columns (x-major) or rows of a line from one end to the other, in its direction: `count`
/// pixels from `first` on, up or down. Its last point is left out.
struct LineSteps {
    std::int64_t first = 0, count = 0;
    bool up = true;

    std::int64_t step_of(std::int64_t pixel) const { return up ? pixel - first : first - pixel; }
};

/// From the major coordinates of both ends, in sub-pixels.
constexpr LineSteps line_steps(std::int64_t from, std::int64_t to, int subpixel_bits) {
    const std::int64_t half = std::int64_t{1} << (subpixel_bits - 1);
    // the first pixel whose centre is at v or above it; the last one at v or below it
    const auto above = [&](std::int64_t v) { return -((half - v) >> subpixel_bits); };
    const auto below = [&](std::int64_t v) { return (v - half) >> subpixel_bits; };
    if (from <= to) return {above(from), above(to) - above(from), true};
    return {below(from), below(from) - below(to), false};
}

/// Whether step `n` of a stippled line makes a fragment.
constexpr bool stipple_bit(const LineStippleState& stipple, std::uint64_t n) {
    return (stipple.pattern >> (n / std::uint64_t(stipple.factor) % 16) & 1) != 0;
}

}  // namespace gw
