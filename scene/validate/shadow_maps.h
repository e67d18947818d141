// What comes nearer to a light than its shadow map begins, or to a mirror than its map of the
// scene. Does not draw.
#pragma once

#include "scene/scene.h"

#include <string>

namespace gw::scene {

/// "light 'lamp': ..." of the first light whose map leaves out a face that casts shadows; empty: all
/// maps reach to what is near.
std::string cut_by_shadow_map(const Scene& scene);

/// The same for a map of its surroundings that an object reflects or refracts.
std::string cut_by_scene_map(const Scene& scene);

}  // namespace gw::scene
