// Surfaces that are metal in some texels and a dielectric in others, as maps of Kd and Ks. All texels
// have the mean roughness, since a material has one Ns.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

namespace gw::scene {

/// Sets the words and maps of all materials that have a map_metal with a texture.
void apply_metal_maps(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
