// Means of textures, for what cannot be drawn texel by texel. Does not read pictures.
#pragma once

#include "scene/scene.h"

namespace gw::scene {

/// The mean colour of its texels, decoded if they are encoded as in sRGB.
dvec3 mean_of(const Texture& texture, bool is_encoded);

/// One texel in place of each map of colours that is a mean: Map::is_mean.
void replace_by_means(Scene& scene);

/// By channel: Kd times the mean of the texels of map_Kd, decoded if the material is encoded.
dvec3 reflectance_of(const Material& material);

}  // namespace gw::scene
