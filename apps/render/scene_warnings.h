// Warns of parts of a scene that a picture will not show right (scene/validate/warnings_of.h).
#pragma once

#include "apps/command/option_values.h"
#include "scene/validate/warnings_of.h"

#include <vector>

namespace gw::apps {

/// For the scene's own camera.
void print_warnings_of(const scene::Scene& scene, const Size& size, scene::DrawnBy by);

/// Says if the colour plane shows nothing of the scene.
void print_if_empty(const scene::Scene& scene, const std::vector<Rgba>& color, int color_bits);

}  // namespace gw::apps
