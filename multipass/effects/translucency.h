// The order of translucent objects [K3.4]: by the centroids of their polygons, or exactly, pixel by
// pixel, as layers. Does not blend.
//
// Layers go beyond the paper: each layer of faces has its own Z. Everett 2001 peels depth with a
// second Z comparison; the VGX has one. Here the machine draws the first, second, ... translucent
// fragment of every pixel in the order of drawing, told apart by counting in the stencil. The host
// sorts their Z and writes the r-th farthest of every pixel back into the Z-buffer, where a pass
// under Equal draws that layer.
#pragma once

#include "gw/machine.h"
#include "multipass/steps/placed_model.h"

#include <cstdint>
#include <vector>

namespace gw::multipass {

/// The triangles of all translucent parts, farthest centroid (along the line of sight) first. Wrong,
/// as all sorting by centroids, if polygons pierce each other or overlap in a cycle
/// (docs/passes.md). Successive triangles of one part make a portion; those of parts of one name in one
/// plane count as successive, since they hide nothing of each other. Triangles at equal distance keep
/// the order of objects and triangles.
std::vector<Portion> far_to_near(const PlacedModel& placed);

/// Far to near; every layer has the window's size, bottom row first.
struct Layers {
    std::vector<std::vector<std::uint32_t>> depth;
    /// For the stencil: 1 on pixels that have this layer, else 0.
    std::vector<std::vector<std::uint32_t>> present;
    std::vector<std::uint32_t> opaque;  ///< Z of the opaque picture
};

/// The visible layers of the current picture; the machine's Z-buffer holds the opaque objects.
/// Overwrites Z and stencil, keeps colour. Faces of equal Z at a pixel are one layer. Throws Error
/// if a pixel has more translucent faces than the stencil counts.
Layers find_layers(Machine& machine, const PlacedModel& placed);

/// Writes layer `index` to Z, and 1 to the stencil of its pixels: a pass under Equal draws it.
void begin_layer(CommandList& list, const PlacedModel& placed, const Layers& layers,
                 std::size_t index);

/// Restores the opaque picture's Z, and stencil 0.
void end_layers(CommandList& list, const PlacedModel& placed, const Layers& layers);

}  // namespace gw::multipass
