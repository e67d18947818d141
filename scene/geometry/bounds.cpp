// The box around a scene. Every vertex counts, even if no polygon uses it.
#include "scene/scene.h"

#include <glm/common.hpp>

namespace gw::scene {

Bounds bounds(const Scene& scene) {
    Bounds box;
    for (const Object& object : scene.objects)
        for (const vec3& position : object.mesh->data().positions)
            extend(box, dvec3(object.world_from_object * dvec4(dvec3(position), 1)));
    return box;
}

void extend(Bounds& box, const dvec3& p) {
    box.low = box.empty ? p : glm::min(box.low, p);
    box.high = box.empty ? p : glm::max(box.high, p);
    box.empty = false;
}

}  // namespace gw::scene
