// Warns of parts of a scene that a picture will not show right (scene/validate/warnings_of.h).
#pragma once

#include "apps/command/option_values.h"
#include "scene/validate/warnings_of.h"

#include <string>
#include <vector>

namespace gw::apps {

/// For the scene's own camera.
void print_warnings_of(const scene::Scene& scene, const Size& size, scene::DrawnBy by);

/// A warning for each line that is not empty.
void print_warnings(const std::vector<std::string>& lines);

}  // namespace gw::apps
