#include "hiddensurface/interface/styles.h"

#include "scene/draw/draw_commands.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

constexpr double depth_shift = 1.0 / 1024;

CommandList begin(const std::string& name, const State& state) {
    CommandList list;
    list.add(BeginPass{.name = name});
    list.add(SetState{state});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth))});
    return list;
}

State lines(const scene::View& view) {
    State state = scene::view_state(view);
    state.polygon_mode = PolygonMode::Line;
    state.color_source = ColorSource::Vertex;
    state.depth = {.test = false};
    return state;
}

/// The least and greatest distance of a vertex before the eye.
std::pair<float, float> depth_extent(const scene::Scene& scene, const scene::View& view) {
    double nearest = view.camera.far_plane, farthest = view.camera.near_plane;
    for (const scene::Object& object : scene.objects) {
        const dmat4 eye_from_object = scene::placed(object, view).eye_from_object;
        for (const vec3& p : object.mesh->data().positions) {
            const double d =
                -(transform3(dmat3(eye_from_object), dvec3(p)).z + eye_from_object[3].z);
            nearest = std::min(nearest, d);
            farthest = std::max(farthest, d);
        }
    }
    nearest = std::max(nearest, view.camera.near_plane);
    return {float(nearest), float(std::max(farthest, nearest * 1.001))};
}

}  // namespace

CommandList wireframe(const scene::Scene& scene, const scene::View& view) {
    CommandList list = begin("wireframe", lines(view));
    scene::add_shapes(list, scene, view);
    return list;
}

CommandList depth_cueing(const scene::Scene& scene, const scene::View& view) {
    State state = lines(view);
    const auto [nearest, farthest] = depth_extent(scene, view);
    // The farthest lines stay visible.
    state.fog = {.enable = true,
                 .mode = FogMode::Linear,
                 .start = nearest,
                 .end = farthest + 0.1f * (farthest - nearest),
                 .color = vec4(0, 0, 0, 1)};
    CommandList list = begin("depth cueing", state);
    scene::add_shapes(list, scene, view);
    return list;
}

CommandList hidden_lines(const scene::Scene& scene, const scene::View& view,
                         const Profile& profile) {
    State faces = scene::view_state(view), sides = lines(view);
    faces.color_source = ColorSource::Vertex;
    faces.color_mask = {false, false, false, false};
    sides.depth = {.test = true, .func = DepthFunc::LEqual, .mask = false};
    if (profile.extensions.polygon_offset) {
        faces.polygon_offset = {.enable = true, .factor = 1, .units = 2};
    } else {
        faces.depth_range.near_value = depth_shift;
        sides.depth_range.far_value = 1 - depth_shift;
    }
    CommandList list = begin("hidden lines: background", lines(view));
    list.add(BeginPass{.name = "hidden lines: faces"});
    list.add(SetState{faces});
    scene::add_shapes(list, scene, view);
    list.add(BeginPass{.name = "hidden lines: sides"});
    list.add(SetState{sides});
    scene::add_shapes(list, scene, view);
    return list;
}

}  // namespace gw::hiddensurface
