// The pattern of a stippled line. docs/manual/rasterization.md, "Coverage". Does not cover pixels.
#pragma once

#include "gw/state.h"

#include <cstdint>

namespace gw {

/// Whether step `n` of a stippled line makes a fragment.
constexpr bool stipple_bit(const LineStippleState& stipple, std::uint64_t n) {
    return (stipple.pattern >> (n / std::uint64_t(stipple.factor) % 16) & 1) != 0;
}

}  // namespace gw
