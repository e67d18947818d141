// bench_raytracing -o DIR: the rays of an ordinary ray tracing by kind, and the building of
// hierarchies, beside Embree, on one thread, in processor time. Writes DIR/rays.csv and prints a
// table. Passes against rays are measured by `gw study passes`.
#include "bench/raytracing/ray_set.h"
#include "image/output/output_set.h"
#include "image/textures.h"
#include "raytrace/tracer/traced_material.h"
#include "scene/scene_builder.h"
#include "scene/toml/read_scene.h"
#include "scene/toml/shape_table.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace gw::bench {
namespace {

constexpr int width = 640, height = 480;

struct Options {
    std::filesystem::path folder;
    int runs = 2;
};

scene::Scene fig9() {
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/fig9.toml").scene;
    image::load_textures(scene);
    return scene;
}

/// The same room with a million triangles: twelve balls instead of what reflects.
scene::Scene room_of_balls() {
    scene::Scene scene = fig9();
    const auto sphere = std::ranges::find(scene::shapes(), "sphere", &scene::Shape::name);
    std::uint32_t next = 0;
    std::vector<double> values;
    for (const auto& p : sphere->parameters)
        values.push_back(p.name == "radius" ? 0.62 : p.name == "slices" ? 289 : 144.5);
    const MeshRef mesh = scene::make_numbered_mesh(sphere->make(values), next);
    for (scene::Object& object : scene.objects)
        if (raytrace::is_traced(scene.materials[object.material])) {
            const dvec4 place = object.world_from_object[3];
            object.mesh = mesh;
            object.world_from_object = dmat4(1);
            object.world_from_object[3] = place;
        }
    return scene;
}

struct Kind {
    const char* name;
    Race race;
};
std::vector<Kind> kinds(const RayRaces& r) {
    return {{"primary", r.primary},
            {"reflected", r.reflected},
            {"shadow", r.shadow},
            {"build", r.build}};
}

void say(const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
}

std::string run_race(const std::string& name, const scene::Scene& scene, int runs) {
    const raytrace::World world(scene, 1);
    const RayRaces races =
        race(rays_of_picture(scene, world, scene::make_view(scene, width, height)), world, runs);
    std::string csv;
    for (const Kind& k : kinds(races)) {
        say(
            fmt::format("{:>9} {:>9} {:>10} {:>9} {:>9.4f} {:>9.4f} {:>9.4f} {:>7.2f} {:>9.2f} "
                        "{:>7}\n",
                        name, world.triangles().size(), k.name, k.race.rays, k.race.ours,
                        k.race.float32, k.race.embree, k.race.embree / k.race.ours,
                        k.race.embree / k.race.float32, k.race.differ));
        csv += fmt::format("{},{},{},{},{:.5f},{:.5f},{:.5f},{}\n", name, world.triangles().size(),
                           k.name, k.race.rays, k.race.ours, k.race.float32, k.race.embree,
                           k.race.differ);
    }
    return csv;
}

int run(const Options& options) {
    say(fmt::format("{:>9} {:>9} {:>10} {:>9} {:>9} {:>9} {:>9} {:>7} {:>9} {:>7}\n", "scene",
                    "triangles", "kind", "rays", "ours s", "float32 s", "Embree s", "E/ours",
                    "E/float32", "differ"));
    std::string text = "scene,triangles,kind,rays,ours_s,float32_s,embree_s,differ\n";
    text += run_race("Fig. 9", fig9(), options.runs);
    text += run_race("balls", room_of_balls(), options.runs);
    image::OutputSet output;
    output.make_folder(options.folder);
    output.add(options.folder / "rays.csv").write_text(text);
    output.commit();
    return 0;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    CLI::App app("Rays beside Embree");
    gw::bench::Options options;
    app.add_option("-o,--output", options.folder, "Folder of the table")->required();
    app.add_option("--runs", options.runs, "Runs, of which the best counts")
        ->check(CLI::Range(1, 100));
    CLI11_PARSE(app, argc, argv);
    try {
        return gw::bench::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_raytracing: {}\n", error.what());
        return 1;
    }
}
