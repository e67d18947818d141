#include "render/study/sweeps.h"

#include "gw/base/elementary.h"
#include "raytrace/tracer/traced_material.h"
#include "render/options.h"
#include "render/study/divided.h"
#include "scene/draw/item_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::render {
namespace {

std::size_t triangles_of(const scene::Scene& scene) {
    std::size_t sum = 0;
    for (const scene::Object& object : scene.objects) sum += object.mesh->triangles().size();
    return sum;
}

/// Shares of the pixels, by object.
std::vector<double> shares(const Drawing& drawing) {
    const auto machine = make_machine(drawing.request, drawing.profile);
    const auto ids = scene::draw_item_buffer(*machine, drawing.scene, drawing.view(), {});
    const scene::PolygonIds numbers = scene::polygon_ids(drawing.scene);
    std::vector<double> share(drawing.scene.objects.size());
    for (const std::uint32_t id : ids)
        if (const auto polygon = scene::polygon_of(numbers, id))
            share[polygon->object] += 1.0 / double(ids.size());
    return share;
}

std::string no_triangles(const Drawing& d) {
    return triangles_of(d.scene) == 0 ? "the scene has no surfaces" : "";
}
std::string allowed(const Drawing&) { return ""; }

Drawing with_size(Drawing d, int width) {
    const Size size = d.request.size;
    const int height = int(std::lround(double(width) * size.height / size.width));
    d.request.size = {width, std::clamp(height, 1, max_window_size)};
    return d;
}

}  // namespace

const Cost& StudyRow::cost(const std::string& method) const {
    return *std::ranges::find(costs, method, &Cost::method);
}

double StudyRow::share() const {
    const double pixels = double(cost("ray-tracing").rays.primary);
    return pixels > 0 ? double(cost("item-buffer").rays.primary) / pixels : 0;
}

// NOLINTNEXTLINE(readability-function-size): a table
const std::vector<Sweep>& sweeps() {
    static const std::vector<Sweep> all{
        {"lights",
         "lights",
         "number of lights",
         2,
         {1, 2, 4, 8, 16, 32, 64},
         1,
         1024,
         allowed,
         [](Drawing d, int n) {
             d.scene = with_lights(std::move(d.scene), n);
             return d;
         },
         [](const StudyRow& row) { return row.lights; }},
        {"samples",
         "samples a pixel",
         "superposed pictures",
         2,
         {1, 4, 16, 64},
         1,
         most_samples,
         allowed,
         [](Drawing d, int n) {
             d.request.samples = n;
             check_samples(d.request, d.profile);
             return d;
         },
         [](const StudyRow& row) { return row.samples; }},
        {"share",
         "percent of pixels glossy",
         "percent of the pixels that are glossy, at most",
         0,
         {0, 5, 10, 20, 35, 50, 75, 100},
         0,
         100,
         no_triangles,
         [](Drawing d, int percent) {
             d.scene = with_share(d, percent / 100.0);
             return d;
         },
         [](const StudyRow& row) { return 100 * row.share(); }},
        {"polygons",
         "triangles",
         "times that each triangle is divided into four",
         10,
         {0, 1, 2, 3},
         0,
         10,
         no_triangles,
         [](Drawing d, int times) {
             d.scene = divided(std::move(d.scene), times);
             return d;
         },
         [](const StudyRow& row) { return double(row.triangles); }},
        {"resolution",
         "pixels",
         "the picture's width",
         10,
         {160, 320, 640, 1280},
         1,
         max_window_size,
         allowed,
         with_size,
         [](const StudyRow& row) { return double(row.size.width) * row.size.height; }},
        {"depth",
         "rays in a path",
         "rays in a path",
         0,
         {1, 2, 3, 4, 6, 8},
         1,
         most_depth,
         [](const Drawing& d) {
             return raytrace::any_traced(d.scene) ? "" : "nothing in the scene reflects by rays";
         },
         [](Drawing d, int n) {
             d.request.depth = n;
             return d;
         },
         [](const StudyRow& row) { return row.depth; }}};
    return all;
}

const Sweep& no_sweep() {
    static const Sweep none{"scene",
                            "the scene",
                            "",
                            0,
                            {1},
                            1,
                            1,
                            allowed,
                            [](Drawing d, int) { return d; },
                            [](const StudyRow&) { return 1; }};
    return none;
}

const Sweep& sweep_named(const std::string& name) {
    std::vector<std::string> names{no_sweep().name};
    for (const Sweep& sweep : sweeps()) names.push_back(sweep.name);
    one_of("sweep", name, names);
    return name == no_sweep().name ? no_sweep() : *std::ranges::find(sweeps(), name, &Sweep::name);
}

StudyRow measured(const Sweep& sweep, int value, const Drawing& drawing, int runs,
                  const std::function<void(const std::string&)>& say) {
    const Drawing d = sweep.at(drawing, value);
    StudyRow row{.sweep = sweep.name,
                 .value = value,
                 .size = d.request.size,
                 .samples = d.request.samples,
                 .lights = int(d.scene.lights.size()),
                 .depth = d.request.depth,
                 .triangles = triangles_of(d.scene)};
    row.costs = costs(d, runs, [&](const std::string& what) {
        say(fmt::format("{} {}: {}", sweep.name, value, what));
    });
    row.x = sweep.x(row);
    return row;
}

scene::Scene with_lights(scene::Scene scene, int count) {
    const std::vector<scene::Light> given = scene.lights;
    if (given.empty()) return scene;
    const scene::Bounds box = scene::bounds(scene);
    const double reach = 0.1 * std::max(length(box.high - box.low), 1e-6);
    const float part = float(std::min<double>(1, double(given.size()) / count));
    scene.lights.clear();
    for (int i = 0; i < count; ++i) {
        const std::size_t copy = std::size_t(i) / given.size();
        scene::Light light = given[std::size_t(i) % given.size()];
        // Copies lie on a spiral, so that no two fall together.
        const double angle = 2.399963229728653 * double(copy),
                     radius = std::sqrt(double(copy) / double(count));
        const dvec3 away{radius * gw::cos(angle), 0, radius * gw::sin(angle)};
        if (copy > 0) {
            light.name += fmt::format(" {}", copy + 1);
            light.position = vec3(dvec3(light.position) + reach * away);
            if (light.kind == scene::LightKind::Directional)
                light.direction = vec3(dvec3(light.direction) + 0.1 * away);
        }
        light.Ia *= part;
        light.Id *= part;
        if (light.Is) *light.Is *= part;
        scene.lights.push_back(std::move(light));
    }
    return scene;
}

scene::Scene with_share(const Drawing& drawing, double wanted) {
    scene::Scene scene = drawing.scene;
    const std::vector<double> share = shares(drawing);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < share.size(); ++i)
        if (!(scene.materials[scene.objects[i].material].d < 1)) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
    double left = wanted + 1e-9;
    for (const std::size_t i : order) {
        scene::Material m = scene.materials[scene.objects[i].material];
        const bool was_traced = raytrace::traced_material(m).any();
        const bool takes = wanted > 0 && share[i] <= left;
        if (takes) left -= share[i];
        m.refl.clear();
        m.illum = takes ? 3 : 2;
        if (takes && !(was_traced && m.Ks != vec3(0))) m.Ks = vec3(0.4f);
        scene.objects[i].material = scene.materials.size();
        scene.materials.push_back(std::move(m));
    }
    return scene;
}

}  // namespace gw::render
