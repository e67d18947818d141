#include "bench/growth/sweep.h"
#include "hiddensurface/interface/algorithm.h"
#include "multipass/frame/driver.h"
#include "multipass/shadow/topology.h"
#include "radiosity/model/figures.h"
#include "raytrace/tracer/world.h"
#include "scene/draw/fit.h"
#include "scene/draw/item_buffer.h"
#include "scene/shapes/shapes.h"
#include "scene/toml/read_scene.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace gw::growth {
namespace {

constexpr int width = 320, height = 240;

/// Cubes of side `size` on a lattice, 1 apart: of side 1 they share faces.
struct Lattice {
    int count = 1;
    double size = 0.8;
    int materials = 1;
    int lights = 1;
    scene::Shadow shadow = scene::Shadow::None;

    int side() const { return int(std::ceil(std::cbrt(double(count)))); }
    dvec3 place(int i) const {
        const int n = side();
        return {double(i % n), double(i / n % n), double(i / n / n)};
    }
};

scene::Material material(int i, int count) {
    return {.name = fmt::format("m{}", i), .Kd = vec3(0.2f + 0.8f * float(i) / float(count))};
}

/// Objects share a mesh, as those that a scene file describes alike do.
scene::Scene boxes(const Lattice& lattice) {
    scene::Scene scene{.name = "boxes"};
    for (int i = 0; i < lattice.materials; ++i)
        scene.materials.push_back(material(i, lattice.materials));
    const MeshRef mesh = make_mesh(scene::make_box(dvec3(lattice.size), 1));
    for (int i = 0; i < lattice.count; ++i) {
        scene::Object object{.name = fmt::format("box {}", i), .mesh = mesh};
        object.material = std::size_t(i % lattice.materials);
        object.world_from_object[3] = dvec4(lattice.place(i), 1);
        scene.objects.push_back(std::move(object));
    }
    for (int i = 0; i < lattice.lights; ++i)
        scene.lights.push_back({.name = fmt::format("light {}", i),
                                .direction = {0.3f * float(i % 7) - 1, -1, -0.7f},
                                .Id = vec3(1.0f / float(lattice.lights)),
                                .shadow = lattice.shadow});
    scene::add_defaults(scene, width, height);
    return scene;
}

std::string toml_of(const Lattice& lattice) {
    std::string text = "[[light]]\ndirection = [-1, -1, -0.7]\n[material.m]\nKd = 0.8\n";
    for (int i = 0; i < lattice.count; ++i) {
        const dvec3 p = lattice.place(i);
        text += fmt::format(
            "[[object]]\nname = \"b{}\"\nshape = \"box\"\nmaterial = \"m\"\ntranslate = [{}, {}, {}]\n",
            i, p.x, p.y, p.z);
    }
    return text;
}

double read(const Lattice& lattice, int repeats) {
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("bench_growth_{}.toml", getpid());
    std::ofstream(file) << toml_of(lattice);
    const double took = least_time(repeats, [&] { scene::read_scene(file); });
    std::filesystem::remove(file);
    return took;
}

double draw(const Lattice& lattice, int repeats) {
    const scene::Scene scene = boxes(lattice);
    const scene::View view = scene::make_view(scene, width, height);
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    return least_time(repeats, [&] {
        multipass::render(*machine, scene, view, {});
        machine->reset_passes();
    });
}

double draw_items(const Lattice& lattice, int repeats) {
    const scene::Scene scene = boxes(lattice);
    const scene::View view = scene::make_view(scene, width, height);
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    return least_time(repeats, [&] { scene::draw_item_buffer(*machine, scene, view, {}); });
}

/// All boxes in one mesh.
double find_topology(const Lattice& lattice, int repeats) {
    MeshData all;
    const MeshRef box = make_mesh(scene::make_box(dvec3(lattice.size), 1));
    for (int i = 0; i < lattice.count; ++i)
        for (const Triangle& t : box->triangles())
            for (const std::uint32_t v : t.vertex)
                all.positions.push_back(box->data().positions[v] + vec3(lattice.place(i)));
    const MeshRef mesh = make_mesh(std::move(all));
    return least_time(repeats, [&] { multipass::topology(*mesh); });
}

double build_hierarchies(const Lattice& lattice, int repeats) {
    const scene::Scene scene = boxes(lattice);
    return least_time(repeats, [&] { raytrace::World(scene, 1); });
}

double make_pixmaps(const Lattice& lattice, int repeats) {
    scene::Scene scene = boxes(lattice);
    scene.materials[0].Ke = vec3(1);
    return least_time(repeats, [&] { radiosity::make_model(scene, {.texels_per_unit = 2}); });
}

double project(const Lattice& lattice, int repeats) {
    const scene::Scene scene = boxes(lattice);
    const scene::View view = scene::make_view(scene, width, height);
    return least_time(repeats, [&] { hiddensurface::make_input(scene, view, vgx()); });
}

using Measure = double (*)(const Lattice&, int repeats);

Sweep by_objects(const char* name, Measure measure, const Lattice& lattice = {},
                 int most = 1000000) {
    Sweep sweep{name, "objects", {}};
    for (int n = 1; n <= most; n *= 10) {
        Lattice l = lattice;
        l.count = n;
        sweep.steps.push_back({double(n), [=](int repeats) { return measure(l, repeats); }});
    }
    return sweep;
}

Sweep by_materials() {
    Sweep sweep{"scene-materials", "materials", {}};
    for (int n = 1; n <= 100000; n *= 10)
        sweep.steps.push_back({double(n), [n](int repeats) {
                                   return draw({.count = 100000, .materials = n}, repeats);
                               }});
    return sweep;
}

Sweep by_lights() {
    Sweep sweep{"scene-lights", "lights", {}};
    for (int n = 1; n <= 256; n *= 4)
        sweep.steps.push_back(
            {double(n), [n](int repeats) { return draw({.count = 1000, .lights = n}, repeats); }});
    return sweep;
}

}  // namespace

std::vector<Sweep> scene_sweeps() {
    return {by_objects("scene-read", read),
            by_objects("scene-draw", draw),
            by_objects("scene-ties", draw, {.size = 1}),
            by_objects("scene-volumes", draw, {.shadow = scene::Shadow::Volume}),
            by_objects("scene-topology", find_topology),
            by_objects("scene-items", draw_items),
            by_objects("scene-hierarchy", build_hierarchies),
            by_objects("scene-pixmaps", make_pixmaps),
            by_objects("scene-hidden", project),
            by_materials(),
            by_lights()};
}

}  // namespace gw::growth
