// The differences of another renderer's planes by cause. Does not execute anything.
#pragma once

#include "inspect/compare/painted.h"

#include <array>

namespace gw::inspect {

/// A pixel may count in several: one of the colours, Depth, Stencil.
enum class Cause : std::uint8_t {
    Coverage,      ///< a side fell between other pixels (an edge, classify.h), in any plane
    Color,         ///< colours of untextured primitives, pixels and clears
    Texture,       ///< colours of textured primitives and pixels
    Antialiasing,  ///< colours of smooth points, lines and polygons
    Depth,
    Stencil,
};
inline constexpr std::size_t cause_count = 6;

struct CauseTally {
    std::uint64_t pixels = 0;
    std::uint64_t sum = 0, largest = 0;  ///< units: of a channel, the largest of the four; of depth
    double mean() const { return pixels == 0 ? 0 : double(sum) / double(pixels); }
    bool operator==(const CauseTally&) const = default;
};
using CauseTallies = std::array<CauseTally, cause_count>;

/// Planes of the same size. `colors`: the colour plane to compare; `painted`: of it.
CauseTallies tally_causes(const Planes& ours, const Planes& theirs, Plane colors,
                          const std::vector<Paint>& painted);
/// Adds pass after pass.
void add(CauseTallies& to, const CauseTallies& more);

}  // namespace gw::inspect
