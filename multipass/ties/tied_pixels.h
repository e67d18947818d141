// Pixels where several fragments have the nearest Z, and the triangles that may have drawn them
// (one_winner.h). Does not draw.
#pragma once

#include "gw/command_list.h"
#include "multipass/frame/placed_model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::multipass {

struct TiedPixels {
    std::vector<Span> spans;  ///< a pixel each
    /// The triangles of opaque parts near such a pixel, in their order; parts of lines or points
    /// whole.
    std::vector<Portion> portions;
};

/// `winners`: the number of fragments with the nearest Z, by pixel of the view, bottom row first.
TiedPixels tied_pixels(const PlacedModel& placed, std::span<const std::uint32_t> winners);

}  // namespace gw::multipass
