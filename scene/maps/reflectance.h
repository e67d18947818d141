// The light that surfaces reflect in all directions, as radiosity counts it [F2.1]. Does not solve.
#pragma once

#include "scene/scene.h"

namespace gw::scene {

/// By channel: Kd times the mean of the texels of map_Kd, decoded if the material is encoded.
dvec3 reflectance_of(const Material& material);

}  // namespace gw::scene
