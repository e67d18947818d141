#include "bench/raytracing/sweep.h"

#include "gw/machine.h"
#include "image/textures.h"
#include "raytrace/tracer/traced_material.h"
#include "scene/draw/item_buffer.h"
#include "scene/scene_builder.h"
#include "scene/toml/read_scene.h"
#include "scene/toml/shape_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::bench {
namespace {

/// N lamps on a circle below the ceiling, as bright together as one.
void set_lights(scene::Scene& scene, int count) {
    const scene::Light lamp = scene.lights.front();
    scene.lights.assign(std::size_t(count), lamp);
    for (int i = 0; i < count; ++i) {
        scene::Light& light = scene.lights[std::size_t(i)];
        const double angle = 2 * M_PI * (i + 0.25) / count;
        light.name = fmt::format("lamp {}", i + 1);
        light.position = vec3(float(4 * std::sin(angle)), 4.6f, float(2 + 3 * std::cos(angle)));
        light.Ia = lamp.Ia / float(count);
        light.Id = vec3(1.0f / float(count));
    }
}

/// Pixels that show each object.
std::vector<double> shares(const scene::Scene& scene) {
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    const auto ids =
        scene::draw_item_buffer(*machine, scene, scene::make_view(scene, width, height), {});
    const scene::PolygonIds numbers = scene::polygon_ids(scene);
    std::vector<double> share(scene.objects.size());
    for (const std::uint32_t id : ids)
        if (const auto polygon = scene::polygon_of(numbers, id))
            share[polygon->object] += 1.0 / (width * height);
    return share;
}

/// Makes objects glossy, the largest that fit first, until about this share of the pixels is.
void set_share(scene::Scene& scene, double wanted) {
    const std::vector<double> share = shares(scene);
    std::vector<std::size_t> order(share.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
    double left = wanted + 0.005;
    for (const std::size_t i : order) {
        scene.materials.push_back(scene.materials[scene.objects[i].material]);
        scene.objects[i].material = scene.materials.size() - 1;
        scene::Material& m = scene.materials.back();
        const bool takes = share[i] <= left;
        if (takes) left -= share[i];
        m.illum = takes ? 3 : 2;
        m.Ks = vec3(takes ? 0.4f : 0.0f);
        m.refl.clear();
    }
}

/// Twelve balls of about `polygons` triangles together in the room, instead of its objects.
void set_polygons(scene::Scene& scene, double polygons) {
    const auto& shapes = scene::shapes();
    const auto sphere = std::find_if(shapes.begin(), shapes.end(),
                                     [](const auto& s) { return s.name == "sphere"; });
    const double slices = std::max(4.0, std::round(std::sqrt(polygons / 12)));
    std::uint32_t next = 0;
    std::vector<double> values;
    for (const auto& p : sphere->parameters)
        values.push_back(p.name == "radius"   ? 0.62
                         : p.name == "slices" ? slices
                                              : std::max(2.0, slices / 2));
    const MeshRef mesh = scene::make_numbered_mesh(sphere->make(values), next);
    for (scene::Object& object : scene.objects)
        if (raytrace::is_traced(scene.materials[object.material])) {
            const dvec4 place = object.world_from_object[3];
            object.mesh = mesh;
            object.world_from_object = dmat4(1);
            object.world_from_object[3] = place;
        }
}

}  // namespace

scene::Scene fig9() {
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/fig9.toml").scene;
    image::load_textures(scene);
    return scene;
}

scene::Scene room_of_balls(double triangles) {
    scene::Scene scene = fig9();
    set_polygons(scene, triangles);
    return scene;
}

std::vector<Sweep> sweeps() {
    const auto with_lights = [](double n) {
        scene::Scene s = fig9();
        set_lights(s, int(n));
        return s;
    };
    const auto with_share = [](int lights) {
        return [lights](double percent) {
            scene::Scene s = fig9();
            set_lights(s, lights);
            set_share(s, percent / 100);
            return s;
        };
    };
    const std::vector<double> percents{0, 5, 10, 20, 32, 50, 75, 100};
    return {{"fig9", "Fig. 9", 0, {1}, [](double) { return fig9(); }},
            {"lights", "lights with shadows", 2, {1, 2, 4, 8, 16, 32, 64}, with_lights},
            {"share_1_light", "percent of pixels glossy", 0, percents, with_share(1)},
            {"share_4_lights", "percent of pixels glossy", 0, percents, with_share(4)},
            {"polygons", "polygons", 10, {1e3, 1e4, 1e5, 1e6, 5e6}, room_of_balls},
            {"samples", "samples a pixel", 2, {1, 4, 16, 64}, [](double) { return fig9(); }, true}};
}

}  // namespace gw::bench
