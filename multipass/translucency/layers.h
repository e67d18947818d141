// Translucent objects in exact order, pixel by pixel: their faces as layers, each with its own Z
// [K3.4, beyond the paper]. Everett 2001 peels depth with a second Z comparison; the VGX has one.
// Here the machine draws the first, second, ... translucent fragment of every pixel in the order of
// drawing, told apart by counting in the stencil; the host sorts their Z and writes the r-th
// farthest of every pixel back into the Z-buffer, where a pass under Equal draws that layer. Does
// not draw the layers' colours.
#pragma once

#include "gw/machine.h"
#include "multipass/frame/placed_model.h"

#include <cstdint>
#include <vector>

namespace gw::multipass {

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
