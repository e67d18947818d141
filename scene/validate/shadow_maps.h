// What comes nearer to a light than its shadow map begins. Does not draw.
#pragma once

#include "scene/scene.h"

#include <string>

namespace gw::scene {

/// "light 'lamp': ..." of the first light whose map leaves out a face that casts shadows; empty: all
/// maps reach to what is near.
std::string cut_by_shadow_map(const Scene& scene);

}  // namespace gw::scene
