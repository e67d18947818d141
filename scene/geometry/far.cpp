#include "scene/geometry/far.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
dvec3 far_origin(const Bounds& box, double ratio) {
    double side = 0, farthest = 0;
    for (int k = 0; k < 3; ++k) {
        side = std::max(side, box.high[k] - box.low[k]);
        farthest = std::max({farthest, std::abs(box.low[k]), std::abs(box.high[k])});
    }
    if (!(side > 0) || !(farthest > ratio * side)) return dvec3(0);
    const double step = std::ldexp(1.0, std::ilogb(side));
    dvec3 origin(0);
    for (int k = 0; k < 3; ++k)
        origin[k] = std::round((box.low[k] / 2 + box.high[k] / 2) / step) * step;
    return origin;
}

dvec3 far_origin(const Scene& scene) {
    Bounds box = bounds(scene);
    if (scene.camera) {
        extend(box, scene.camera->eye);
        extend(box, scene.camera->at);
    }
    for (const Light& light : scene.lights)
        if (light.kind != LightKind::Directional) extend(box, dvec3(light.position));
    return far_origin(box);
}

void count_from(Camera& camera, const dvec3& origin) {
    camera.eye -= origin;
    camera.at -= origin;
}

void count_from(Scene& scene, const dvec3& origin) {
    for (Object& object : scene.objects) object.world_from_object[3] -= dvec4(origin, 0);
    if (scene.camera) count_from(*scene.camera, origin);
}

}  // namespace gw::scene
