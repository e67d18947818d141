// bench_raytracing -o DIR: pass count against ray tracing [K4f]. Frames of eq. 5 with an item buffer, the
// ordinary ray tracer's, and Embree on the same rays, on one thread, in processor time; swept over lights,
// glossy share, polygons and samples. Writes DIR/NAME.svg and .csv of each sweep, and prints tables.
#include "contest.h"
#include "gw/error.h"
#include "image/output_set.h"
#include "image/textures.h"
#include "itembuffer/item_buffer.h"
#include "plot/plot.h"
#include "ray_set.h"
#include "scene/polygon_ids.h"
#include "scene/read_scene.h"
#include "scene/shape_table.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace gw::bench {
namespace {

struct Options {
    std::filesystem::path folder;
    std::string sweep = "all";
    int runs = 2;
};

scene::Scene fig9() {
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/fig9.toml").scene;
    image::load_textures(scene);
    return scene;
}

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
        itembuffer::draw_item_buffer(*machine, scene, scene::make_view(scene, width, height), {});
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

/// Twelve balls of about `polygons` triangles together in the room, instead of what lies there.
void set_polygons(scene::Scene& scene, double polygons) {
    const auto& shapes = scene::shapes();
    const auto sphere =
        std::find_if(shapes.begin(), shapes.end(), [](const auto& s) { return s.name == "sphere"; });
    const double slices = std::max(4.0, std::round(std::sqrt(polygons / 12)));
    std::uint32_t next = 0;
    std::vector<double> values;
    for (const auto& p : sphere->parameters)
        values.push_back(p.name == "radius" ? 0.62 : p.name == "slices" ? slices : std::max(2.0, slices / 2));
    const MeshRef mesh = scene::make_numbered_mesh(sphere->make(values), next);
    for (scene::Object& object : scene.objects)
        if (raytrace::is_traced(scene.materials[object.material])) {
            const dvec4 place = object.world_from_object[3];
            object.mesh = mesh;
            object.world_from_object = dmat4(1);
            object.world_from_object[3] = place;
        }
}

struct Row {
    double x;
    Contest c;
    TraceTimes rays;
};

struct Sweep {
    std::string name, x_label;
    int log;
    std::vector<double> values;
    std::function<scene::Scene(double)> scene;
    bool samples = false;
};

Row run(const Sweep& sweep, double x, int runs) {
    const scene::Scene scene = sweep.scene(x);
    Row row{x, contest(scene, sweep.samples ? int(x) : 1, runs), {}};
    const scene::View view = scene::make_view(scene, width, height);
    const raytrace::World world(scene, 1);
    row.rays = trace_times(rays_of_picture(scene, world, view), world);
    return row;
}

plot::Plot times_plot(const Sweep& sweep, const std::vector<Row>& rows) {
    plot::Plot p{
        .title = "Seconds of a frame, by " + sweep.x_label,
        .caption = "Processor seconds of one thread, 640x480, to the second ray; hierarchies built before.",
        .command = "build/release/bin/bench_raytracing --sweep " + sweep.name + " -o DIR",
        .x = {sweep.x_label, sweep.log},
        .y = {"seconds", 10}};
    const auto add = [&](const char* name, auto value) {
        plot::Series series{.name = name};
        for (const Row& row : rows) series.points.emplace_back(row.x, value(row));
        p.series.push_back(std::move(series));
    };
    const double samples = 1;
    add("item buffer, shadow rays", [](const Row& r) { return r.c.item_buffer; });
    add("item buffer, shadow maps", [](const Row& r) { return r.c.item_buffer_maps; });
    add("ordinary ray tracing", [](const Row& r) { return r.c.ray_tracing; });
    add("its rays only", [&](const Row& r) { return r.rays.ours * (sweep.samples ? r.x : samples); });
    add("Embree, the same rays",
        [&](const Row& r) { return r.rays.embree * (sweep.samples ? r.x : samples); });
    return p;
}

plot::Plot gain_plot(const Sweep& sweep, const std::vector<Row>& rows) {
    plot::Plot p{
        .title = "Ordinary ray tracing over item buffer, by " + sweep.x_label,
        .caption = "The paper says 3 to 5 [K4f]. The bound holds for exact shadow rays, were passes free.",
        .command = "build/release/bin/bench_raytracing --sweep " + sweep.name + " -o DIR",
        .x = {sweep.x_label, sweep.log},
        .y = {"times faster", 0}};
    plot::Series rays{.name = "with shadow rays"}, maps{.name = "with shadow maps"},
        bound{.name = "1 + 1/g", .markers = false, .dashed = true},
        low{.name = "the paper's 3", .markers = false, .dashed = true},
        high{.name = "the paper's 5", .markers = false, .dashed = true};
    for (const Row& row : rows) {
        rays.points.emplace_back(row.x, row.c.gain());
        maps.points.emplace_back(row.x, row.c.gain_maps());
        if (row.c.share > 0) bound.points.emplace_back(row.x, std::min(row.c.bound(), 15.0));
        low.points.emplace_back(row.x, 3);
        high.points.emplace_back(row.x, 5);
    }
    p.series = {rays, maps, bound, low, high};
    return p;
}

std::string numbers(const std::vector<Row>& rows) {
    std::string text =
        "x,triangles,glossy_share,item_buffer_s,of_this_traced_s,item_buffer_maps_s,ray_tracing_s,hierarchy_"
        "s,"
        "rays_ours_s,rays_embree_s,rays_differ,gain,gain_maps,bound,item_buffer_second_rays,"
        "item_buffer_shadow_rays,ray_tracing_primary,ray_tracing_second_rays,ray_tracing_shadow_rays,"
        "maps_pixels_differ,maps_mean_error\n";
    for (const Row& r : rows) {
        const auto &a = r.c.item_buffer_rays, &b = r.c.ray_tracing_rays;
        text += fmt::format(
            "{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{:.3f},{:.3f},{:.3f},"
            "{},{},{},{},{},{:.5f},{:.4f}\n",
            r.x, r.c.triangles, r.c.share, r.c.item_buffer, r.c.traced, r.c.item_buffer_maps, r.c.ray_tracing,
            r.c.hierarchy, r.rays.ours, r.rays.embree, r.rays.differ, r.c.gain(), r.c.gain_maps(),
            r.c.bound(), a.reflected + a.transmitted, a.shadow, b.primary, b.reflected + b.transmitted,
            b.shadow, r.c.maps_differ, r.c.maps_error);
    }
    return text;
}

void print_row(const Row& r) {
    fmt::print(
        "{:>9} {:>9} {:>6.1f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>7.2f} {:>7.2f} {:>7.2f} "
        "{:>6.2f}\n",
        r.x, r.c.triangles, 100 * r.c.share, r.c.item_buffer, r.c.traced, r.c.item_buffer_maps,
        r.c.ray_tracing, r.rays.embree, r.c.gain(), r.c.gain_maps(), r.c.bound(),
        r.rays.embree / r.rays.ours);
    std::fflush(stdout);
}

void run(const Sweep& sweep, const Options& options) {
    fmt::print("{}\n{:>9} {:>9} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7} {:>7} {:>6}\n", sweep.name,
               "x", "triangles", "g %", "item s", "traced s", "maps s", "rays s", "Embree s", "gain",
               "by maps", "1+1/g", "E/ours");
    std::vector<Row> rows;
    for (const double x : sweep.values) {
        rows.push_back(run(sweep, x, options.runs));
        print_row(rows.back());
    }
    image::OutputSet output;
    output.make_folder(options.folder);
    output.add(options.folder / (sweep.name + ".csv")).write_text(numbers(rows));
    if (rows.size() > 1) {
        output.add(options.folder / (sweep.name + "_seconds.svg"))
            .write_text(plot::svg(times_plot(sweep, rows)));
        output.add(options.folder / (sweep.name + "_gain.svg")).write_text(plot::svg(gain_plot(sweep, rows)));
    }
    output.commit();
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
    const auto with_polygons = [](double n) {
        scene::Scene s = fig9();
        set_polygons(s, n);
        return s;
    };
    const std::vector<double> percents{0, 5, 10, 20, 32, 50, 75, 100};
    return {{"fig9", "Fig. 9", 0, {1}, [](double) { return fig9(); }},
            {"lights", "lights with shadows", 2, {1, 2, 4, 8, 16, 32, 64}, with_lights},
            {"share_1_light", "percent of pixels glossy", 0, percents, with_share(1)},
            {"share_4_lights", "percent of pixels glossy", 0, percents, with_share(4)},
            {"polygons", "polygons", 10, {1e3, 1e4, 1e5, 1e6, 5e6}, with_polygons},
            {"samples", "samples a pixel", 2, {1, 4, 16, 64}, [](double) { return fig9(); }, true}};
}

int run(const Options& options) {
    for (const Sweep& sweep : sweeps())
        if (options.sweep == "all" || options.sweep == sweep.name) run(sweep, options);
    return 0;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    CLI::App app("Pass count against ray tracing");
    gw::bench::Options options;
    std::vector<std::string> names{"all"};
    for (const auto& sweep : gw::bench::sweeps()) names.push_back(sweep.name);
    app.add_option("-o,--output", options.folder, "Folder of the plots and tables")->required();
    app.add_option("--sweep", options.sweep, "Only this one")->check(CLI::IsMember(names));
    app.add_option("--runs", options.runs, "Best of so many")->check(CLI::Range(1, 100));
    CLI11_PARSE(app, argc, argv);
    try {
        return gw::bench::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_raytracing: {}\n", error.what());
        return 1;
    }
}
