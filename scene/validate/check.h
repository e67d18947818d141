// Scenes that code has built: they have been through no reader of files.
#pragma once

#include "scene/scene.h"

namespace gw::scene {

/// Throws Error "light 'sun', direction: 0; expected a direction that is not 0" for values that no
/// file can have (limits.h, rules.h), objects without mesh or material, and maps without texture.
void check_scene(const Scene& scene);

}  // namespace gw::scene
