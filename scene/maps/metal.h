// Surfaces whose metallic part or F0 differs from texel to texel, as maps of Ka, Kd and Ks. All texels
// have the mean roughness, since a material has one Ns.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

namespace gw::scene {

/// Sets the words and maps of all materials that are Material::physical.
void apply_metal_maps(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
