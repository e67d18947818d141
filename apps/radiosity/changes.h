// Changes of a scene by name, for gw radiosity --change [F4]. Does not solve.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace gw::apps {

/// "lamp:emission=1,2,3" and its like.
struct Change {
    std::string object;  ///< all objects of this name
    std::string what;    ///< emission, dim, Kd or move
    dvec3 value{0};      ///< dim: three times its factor
};

/// Throws UsageError saying what was expected.
Change change_from(const std::string& word);

/// Throws UsageError where no object has the name, or it emits nothing that could be dimmed.
void apply(const Change& change, scene::Scene& scene);

}  // namespace gw::apps
