// Changes of a scene by name [F4]: emitters and reflectances of objects, and where they are. Does
// not solve.
#pragma once

#include "scene/scene.h"

#include <string>

namespace gw::radiosity {

/// "lamp:emission=1,2,3" and its like.
struct Change {
    std::string object;  ///< all objects of this name
    std::string what;    ///< emission, dim, Kd or move
    dvec3 value{0};      ///< dim: three times its factor
};

/// Throws Error if no object has the name.
void apply(const Change& change, scene::Scene& scene);

}  // namespace gw::radiosity
