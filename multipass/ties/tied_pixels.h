// Pixels where the nearest Z belongs to several fragments, and the triangles that may have made
// them: where coincident faces need care (one_winner.h). Does not draw.
#pragma once

#include "gw/command_list.h"
#include "multipass/frame/placed_model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::multipass {

struct TiedPixels {
    std::vector<Span> spans;  ///< a pixel each
    /// Of every opaque part the triangles that come near such a pixel, in their order; all of a
    /// part of lines or points.
    std::vector<Portion> portions;
};

/// `winners`: how many fragments have the nearest Z, by pixel of the stage's view, bottom row
/// first.
TiedPixels tied_pixels(const Stage& stage, std::span<const std::uint32_t> winners);

}  // namespace gw::multipass
