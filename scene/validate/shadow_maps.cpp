#include "scene/validate/shadow_maps.h"

#include "gw/stages/vertex.h"
#include "scene/draw/nearest.h"
#include "scene/draw/view.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gw::scene {
namespace {

/// In parts of a scene's reach: a face this near to the light's point is seen from its edge, as a
/// lamp's that has its light on it.
constexpr double on_face = 1e-6;

double farthest_from(const dvec3& p, const Bounds& box) {
    double farthest = 0;
    for (int i = 0; i < 8; ++i) farthest = std::max(farthest, length(corner(box, i) - p));
    return farthest;
}

/// Of the whole sphere, or of a spot's cone.
std::vector<View> views_around(const Light& light, double far_plane) {
    const dvec3 p(light.position);
    if (light.kind == LightKind::Spot && light.cone_angle < 89) {
        View view{.camera = {.fov = 2 * std::max(light.cone_angle, 0.1), .far_plane = far_plane},
                  .width = 1,
                  .height = 1};
        view.eye_from_world = look_at(p, p + dvec3(light.direction), dvec3(0, 1, 0));
        return {view};
    }
    const auto cube = cube_views(p, far_plane / 2, far_plane, 1);
    return {cube.begin(), cube.end()};
}

Scene casting_objects(const Scene& scene) {
    Scene casting;
    for (const Object& object : scene.objects)
        if (object.casts_shadow && scene.materials[object.material].d >= 1)
            casting.objects.push_back(object);
    return casting;
}

std::string text_of(const Light& light, const Object& object, double distance, double begin) {
    const auto number = [](double value) { return number_text(std::round(value * 1e4) / 1e4); };
    return "light '" + printable(light.name) + "': object '" + printable(object.name) +
           "' comes as near as " + number(distance) +
           ", where it casts no shadow: the shadow map begins at " + number(begin) +
           ", a 65536th of the scene's reach; expected shadow = \"volume\"";
}

}  // namespace

std::string cut_by_shadow_map(const Scene& scene) {
    const Bounds box = bounds(scene);
    for (const Light& light : scene.lights) {
        if (light.shadow != Shadow::Map || light.kind == LightKind::Directional) continue;
        const Scene casting = casting_objects(scene);
        for (const View& view : views_around(light, farthest_from(dvec3(light.position), box))) {
            const double begin = edge_on_in_map(view);
            const Nearest nearest =
                nearest_in(view, casting, begin, on_face * view.camera.far_plane);
            if (nearest.distance < begin)
                return text_of(light, casting.objects[nearest.object], nearest.distance, begin);
        }
    }
    return {};
}

}  // namespace gw::scene
