// Shadow volumes in space: objects of a scene that the machine draws from another eye.
#include "gw/error.h"
#include "multipass/shadow/shadows.h"
#include "web/engine/json_point.h"
#include "web/engine/method.h"
#include "web/engine/outside.h"

namespace gw::lab {
namespace {

std::size_t add_material(scene::Scene& scene, const char* name, const vec3& glow, float opacity) {
    scene.materials.push_back(
        {.name = name, .Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(0), .Ke = glow, .d = opacity});
    return scene.materials.size() - 1;
}

/// A small octahedron that shows where a light or an eye is.
void add_mark(scene::Scene& scene, const dvec3& at, double radius, std::size_t material) {
    MeshData data;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-radius, radius}) {
            dvec3 corner = at;
            corner[axis] += side;
            data.positions.push_back(vec3(corner));
        }
    for (const std::uint32_t x : {0u, 1u})
        for (const std::uint32_t y : {2u, 3u})
            for (const std::uint32_t z : {4u, 5u})
                for (const std::uint32_t corner : {x, y, z}) data.indices.push_back(corner);
    scene.objects.push_back(
        {.name = "mark", .mesh = make_mesh(std::move(data)), .material = material});
}

/// Adds the surfaces of the volumes that the objects of `scene` have. Returns their number.
int add_volumes(scene::Scene& shown, const scene::Scene& scene, std::size_t material) {
    const multipass::PassModel model = multipass::make_pass_model(scene);
    const multipass::Shadows shadows = find_volumes(model, multipass::topologies(model));
    int count = 0;
    for (const auto& of_light : shadows.volumes)
        for (std::size_t part = 0; part < of_light.size(); ++part) {
            if (!of_light[part].caps) continue;
            ++count;
            for (const MeshRef& mesh : {of_light[part].caps, of_light[part].sides})
                if (mesh)
                    shown.objects.push_back(
                        {.name = "volume",
                         .mesh = mesh,
                         .material = material,
                         .world_from_object = model.parts[part].object->world_from_object});
        }
    return count;
}

}  // namespace

Json LabSession::volumes(const Json& options) {
    check_pictures();
    scene::Scene scene = scene_for(options);
    scene::Scene shown = scene;
    const scene::Bounds bounds = scene::bounds(scene);
    for (scene::Light& light : shown.lights) {
        light.shadow = scene::Shadow::None;
        light.area.shape = scene::AreaLight::Shape::None;
    }
    for (scene::Object& object : shown.objects) object.glare.reset();
    shown.camera = outside_camera(scene);
    if (options.contains("from"))
        for (int i = 0; i < 3; ++i) shown.camera->eye[i] = options["from"].at(std::size_t(i));

    const double size = glm::length(bounds.high - bounds.low) * 0.015;
    const std::size_t yellow = add_material(shown, "light", {1, 0.9f, 0.2f}, 1);
    const std::size_t white = add_material(shown, "eye", {1, 1, 1}, 1);
    for (const scene::Light& light : scene.lights)
        if (light.kind != scene::LightKind::Directional)
            add_mark(shown, dvec3(light.position), size, yellow);
    add_mark(shown, scene.camera->eye, size, white);
    const int count =
        add_volumes(shown, scene, add_material(shown, "volume", {0.2f, 0.35f, 0.9f}, 0.3f));
    if (count == 0) throw Error("no light of this scene casts a shadow volume");

    Machine& machine = machine_for(options);
    const scene::Camera seen_by = *shown.camera;
    const scene::View view = view_of(shown, options);
    render::draw({.request = {.translucency = multipass::Translucency::Unsorted,  // of one colour
                              .traced = false},
                  .profile = machine.profile(),
                  .scene = std::move(shown)},
                 view, machine);
    keep_picture(machine);
    return {{"volumes", count},
            {"eye", json_of(seen_by.eye)},
            {"at", json_of(seen_by.at)},
            {"up", json_of(seen_by.up)}};
}

const Method volumes_methods[] = {
    {"volumes", &LabSession::volumes, {{"picture", &LabSession::picture}}},
};

}  // namespace gw::lab
