// Differences of another renderer's planes, which cannot have the same bits: every wrong pixel is
// of one class. Does not execute anything.
#pragma once

#include "gw/planes.h"

namespace gw::inspect {

/// Pixels of a plane that differ. Rounding: the values are close. Each channel of a colour differs
/// by at most 4, a depth by at most 256 units (of 24 bits: 1/65536 of the range); stencil values
/// must be equal. Edge: else, if theirs is close to ours at one of the 8 neighbours: the side of a
/// polygon or line fell between other pixels. Other: all else.
struct Differences {
    std::uint64_t rounding = 0, edge = 0, other = 0;
    std::uint64_t worst = 0;  ///< sum of the channels' absolute differences
    std::uint64_t pixels() const { return rounding + edge + other; }
    bool operator==(const Differences&) const = default;
};

/// The class of one pixel, as above.
enum class Kind : std::uint8_t { Rounding, Edge, Other };
Kind kind_of_difference(const Planes& ours, const Planes& theirs, Plane plane, int x, int y);

/// Planes of the same size; Color, Back, Depth or Stencil.
Differences classify(const Planes& ours, const Planes& theirs, Plane plane);

}  // namespace gw::inspect
