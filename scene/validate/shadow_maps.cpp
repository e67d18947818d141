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

/// Views of the whole sphere, or of a spot's cone.
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

/// What a map around a point leaves out.
struct Cut {
    const Object* object = nullptr;  ///< null: nothing
    double distance = 0, begin = 0;

    std::string text(const std::string& whose, const std::string& effect,
                     const std::string& map) const {
        const auto number = [](double value) { return number_text(std::round(value * 1e4) / 1e4); };
        return whose + ": object '" + printable(object->name) + "' comes as near as " +
               number(distance) + ", where it " + effect + ": the " + map + " begins at " +
               number(begin) + ", a 65536th of the scene's reach; expected ";
    }
};

Cut cut_in(const View& view, const Scene& scene) {
    const double begin = edge_on_in_map(view);
    const Nearest nearest = nearest_in(view, scene, begin, on_face * view.camera.far_plane);
    if (!(nearest.distance < begin)) return {};
    return {&scene.objects[nearest.object], nearest.distance, begin};
}

dvec3 middle_of(const Object& object) {
    const Bounds box = bounds(Scene{.objects = {object}});
    return (box.low + box.high) * 0.5;
}

bool is_generated(const Map& map) { return map.from_scene > 0; }

}  // namespace

std::string cut_by_shadow_map(const Scene& scene) {
    const Bounds box = bounds(scene);
    for (const Light& light : scene.lights) {
        if (light.shadow != Shadow::Map || light.kind == LightKind::Directional) continue;
        const Scene casting = casting_objects(scene);
        for (const View& view : views_around(light, farthest_from(dvec3(light.position), box)))
            if (const Cut cut = cut_in(view, casting); cut.object)
                return cut.text("light '" + printable(light.name) + "'", "casts no shadow",
                                "shadow map") +
                       "shadow = \"volume\"";
    }
    return {};
}

std::string cut_by_scene_map(const Scene& scene) {
    const Bounds box = bounds(scene);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Material& m = scene.materials[scene.objects[i].material];
        if (std::ranges::none_of(m.refl, is_generated) &&
            std::ranges::none_of(m.refraction, is_generated))
            continue;
        Scene others = scene;
        others.objects.erase(others.objects.begin() + std::ptrdiff_t(i));
        const dvec3 middle = middle_of(scene.objects[i]);
        const double reach = reach_around(middle, box);
        for (const View& view : cube_views(middle, reach / 2, reach, 1))
            if (const Cut cut = cut_in(view, others); cut.object)
                return cut.text("object '" + printable(scene.objects[i].name) + "'",
                                "is not reflected", "map of the scene") +
                       "a renderer by rays";
    }
    return {};
}

}  // namespace gw::scene
