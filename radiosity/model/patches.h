// Patches [F2]: the blocks of texels that shoot. Does not choose the points of a patch (points.h).
#pragma once

#include "radiosity/model/pixmap_model.h"

namespace gw::radiosity {

/// In parts of the scene's extent: a surface that rises less above a plane touches it.
inline constexpr double touching = 1e-6;

/// Blocks of side x side texels, those with an area. A block of a plane figure on which another
/// figure stands is divided along the line of contact, down to single texels: one side of it is lit,
/// the other is not.
std::vector<Patch> patches_of(const PixmapModel& model, int side);
/// The same blocks in a model of the same pixmaps.
std::vector<Patch> same_patches(const PixmapModel& model, std::vector<Patch> patches);

}  // namespace gw::radiosity
