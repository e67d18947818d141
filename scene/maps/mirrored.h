// Maps that repeat mirrored, for machines that only repeat: a texture of twice the width or height holds
// the mirror image beside the picture. Does not touch maps of opacity.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

namespace gw::scene {

/// Unfolds all maps with textures. A side of more than 2048 texels is repeated without being mirrored, with
/// a warning.
void unfold_mirrored(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
