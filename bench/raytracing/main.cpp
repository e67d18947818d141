// bench_raytracing -o DIR: pass count against ray tracing [K4f]. Frames of eq. 5 with an item
// buffer, the ordinary ray tracer's, and Embree on the same rays, on one thread, in processor time.
// Sweeps are over lights, glossy share, polygons and samples. Writes DIR/NAME.svg and .csv of each
// sweep, and prints tables. `rays`: rays by kind and the building of hierarchies, beside Embree.
#include "apps/command/peak_memory.h"
#include "bench/raytracing/report.h"
#include "image/output/output_set.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::bench {
namespace {

struct Options {
    std::filesystem::path folder;
    std::string sweep = "all";
    int runs = 2;
    double from = 0, up_to = 1e30;
};

void say(const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
}

Row run(const Sweep& sweep, double x, int runs) {
    const scene::Scene scene = sweep.scene(x);
    Row row{x, contest(scene, sweep.samples ? int(x) : 1, runs), {}};
    const scene::View view = scene::make_view(scene, width, height);
    const raytrace::World world(scene, 1);
    row.rays = race(rays_of_picture(scene, world, view), world, runs);
    row.megabytes = peak_memory() >> 20;
    return row;
}

void run(const Sweep& sweep, const Options& options) {
    say(heading(sweep));
    std::vector<Row> rows;
    for (const double x : sweep.values) {
        if (x < options.from || x > options.up_to) continue;
        rows.push_back(run(sweep, x, options.runs));
        say(line(rows.back()));
    }
    say(crossings(sweep, rows));
    image::OutputSet output;
    output.make_folder(options.folder);
    output.add(options.folder / (sweep.name + ".csv")).write_text(csv(rows));
    if (rows.size() > 1) {
        output.add(options.folder / (sweep.name + "_seconds.svg"))
            .write_text(times_plot(sweep, rows));
        output.add(options.folder / (sweep.name + "_gain.svg")).write_text(gain_plot(sweep, rows));
    }
    output.commit();
}

void run_races(const Options& options) {
    say(race_heading());
    std::string text = "scene,triangles,kind,rays,ours_s,float32_s,embree_s,differ\n";
    const auto run_race = [&](const std::string& name, const scene::Scene& scene) {
        const raytrace::World world(scene, 1);
        const RayRaces races =
            race(rays_of_picture(scene, world, scene::make_view(scene, width, height)), world,
                 options.runs);
        say(race_lines(name, world.triangles().size(), races));
        text += race_csv(name, world.triangles().size(), races);
    };
    run_race("Fig. 9", fig9());
    run_race("balls", room_of_balls(1e6));
    image::OutputSet output;
    output.make_folder(options.folder);
    output.add(options.folder / "rays.csv").write_text(text);
    output.commit();
}

int run(const Options& options) {
    for (const Sweep& sweep : sweeps())
        if (options.sweep == "all" || options.sweep == sweep.name) run(sweep, options);
    if (options.sweep == "all" || options.sweep == "rays") run_races(options);
    return 0;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    CLI::App app("Pass count against ray tracing");
    gw::bench::Options options;
    std::vector<std::string> names{"all", "rays"};
    for (const auto& sweep : gw::bench::sweeps()) names.push_back(sweep.name);
    app.add_option("-o,--output", options.folder, "Folder of the plots and tables")->required();
    app.add_option("--sweep", options.sweep, "Only this one")->check(CLI::IsMember(names));
    app.add_option("--runs", options.runs, "Runs, of which the best counts")
        ->check(CLI::Range(1, 100));
    app.add_option("--from", options.from, "Only values of a sweep from this one on ...");
    app.add_option("--up-to", options.up_to, "... and up to this one");
    CLI11_PARSE(app, argc, argv);
    try {
        return gw::bench::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_raytracing: {}\n", error.what());
        return 1;
    }
}
