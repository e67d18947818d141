// The box around a scene. Every vertex counts, even if no polygon uses it.
#include "scene/scene.h"

#include <glm/common.hpp>

namespace gw::scene {

Bounds bounds(const Scene& scene) {
    Bounds box;
    for (const Object& object : scene.objects)
        for (const vec3& position : object.mesh->data().positions) {
            const dvec3 p_world(object.world_from_object * dvec4(dvec3(position), 1));
            box.low = box.empty ? p_world : glm::min(box.low, p_world);
            box.high = box.empty ? p_world : glm::max(box.high, p_world);
            box.empty = false;
        }
    return box;
}

}  // namespace gw::scene
