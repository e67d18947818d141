// A face's corners in the world. Does not clip.
#pragma once

#include "gw/stages/vertex.h"
#include "scene/scene.h"

#include <array>

namespace gw::scene {

using WorldCorners = std::array<dvec3, 3>;

/// The corners of a triangle of the object's mesh, in the middle of the exposure.
inline WorldCorners world_corners(const Object& object, const Triangle& t) {
    WorldCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const vec3& p = object.mesh->data().positions[t.vertex[k]];
        corners[k] = transform3(dmat3(object.world_from_object), dvec3(p)) +
                     dvec3(object.world_from_object[3]);
    }
    return corners;
}

}  // namespace gw::scene
