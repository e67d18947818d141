// bench_radiosity -o DIR: hemicubes per second against resolution, texels and polygons, with the
// exponents of growth. Beside them, if OSMesa is installed, the same five ID buffers drawn and read
// back through llvmpipe, with LP_NUM_THREADS threads. If Embree is installed, the same hemicubes
// gathered by one ray a pixel, on one thread; it says how many pixels differ. Then the Cornell box
// with 64 texels along a wall to 1 % unshot, with the shares of drawing and scanning. Times are the
// least of interleaved repeats.
#include "gw/base/parallel.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/plot/plot.h"
#include "radiosity/solver/solver.h"
#include "scene/toml/read_scene.h"

#ifdef GW_WITH_EMBREE
#include "bench/radiosity/embree_hemicube.h"
#endif
#ifdef GW_WITH_OSMESA
#include "bench/radiosity/opengl_hemicube.h"
#endif

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

namespace gw::bench {
namespace {

struct Options {
    std::filesystem::path folder;
    int repeats = 5;
    int threads = 1;
    bool cornell = false;
};

/// The scene of the sphere in a box, with a bumpy sheet of 2 segments^2 triangles in place of the
/// sphere.
scene::Scene box_with(int segments) {
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/radiosity/sphere.toml").scene;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int j = 0; j <= segments; ++j)
        for (int i = 0; i <= segments; ++i)
            positions.push_back({float(2 * i) / float(segments) - 1,
                                 0.1f + 0.05f * float((i * 7 + j * 5) % 4) / float(segments),
                                 float(2 * j) / float(segments) - 1});
    const auto at = [&](int i, int j) { return std::uint32_t(j * (segments + 1) + i); };
    for (int j = 0; j < segments; ++j)
        for (int i = 0; i < segments; ++i)
            indices.insert(indices.end(), {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j),
                                           at(i, j + 1), at(i + 1, j + 1)});
    scene.objects[1].mesh = make_mesh({.positions = positions, .indices = indices});
    scene.objects[1].world_from_object = dmat4(1);
    return scene;
}

double milliseconds(const auto& run) {
    const auto begin = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
        .count();
}

/// Milliseconds for a hemicube.
struct Row {
    double x = 0;
    double drawn = 1e9, whole = 1e9;  ///< five ID buffers drawn and read; scanned and summed too
    double llvmpipe = 1e9;            ///< drawn and read
    double embree = 1e9;              ///< gathered
};

/// A painter for each thread, as FormFactors has them [F4].
class Painters {
public:
    Painters(int size, int threads) : threads_(threads), buffers_(std::size_t(threads)) {
        for (int i = 0; i < threads; ++i)
            all_.push_back(std::make_unique<radiosity::HemicubePainter>(size));
    }
    void draw(const radiosity::PixmapModel& model, const std::vector<radiosity::Hemicube>& cubes) {
        parallel_for(cubes.size(), threads_, [&](std::size_t i, int worker) {
            const auto w = std::size_t(worker);
            all_[w]->draw(model, cubes[i], buffers_[w]);
        });
    }

private:
    int threads_;
    std::vector<std::unique_ptr<radiosity::HemicubePainter>> all_;
    std::vector<radiosity::IdBuffers> buffers_;
};

#ifdef GW_WITH_EMBREE
/// The part of a hemicube's pixels that show another facet.
double differing(const radiosity::PixmapModel& model, const radiosity::Hemicube& cube, int size,
                 EmbreeHemicube& peer) {
    radiosity::IdBuffers buffers;
    radiosity::HemicubePainter(size).draw(model, cube, buffers);
    peer.gather(cube);
    std::size_t i = 0, differ = 0;
    for (const radiosity::IdBuffer& buffer : buffers)
        for (const std::uint32_t pixel : buffer.pixels)
            differ += (pixel & 0xFFFFFF) != peer.ids()[i++] ? 1 : 0;
    return double(differ) / double(i);
}
#endif

Row measure(double x, int size, double texels, int segments, const Options& options) {
    const radiosity::PixmapModel model =
        radiosity::make_model(box_with(segments), {.texels_per_unit = texels});
    radiosity::FormFactors factors(model, {.hemicube = size, .threads = options.threads});
    Painters painters(size, options.threads);
    constexpr int at_once = 32;  // four times the number that a solution draws before it scans
    std::vector<radiosity::ShootPoint> points;
    std::vector<radiosity::Hemicube> cubes;  // each from elsewhere, as a solution's are
    for (int k = 0; k < at_once; ++k)
        points.push_back({{0.01 * k, 1.9, 0}, {0, -1, 0}, 1.0 / at_once, 0.1});
    for (int k = 0; k < at_once; ++k)
        cubes.push_back(radiosity::hemicube_at(points[std::size_t(k)].position, {0, -1, 0},
                                               30 + 5 * k, 0.1 / 64, 5, size));
#ifdef GW_WITH_OSMESA
    OpenGlHemicube peer(model, size);
#endif
#ifdef GW_WITH_EMBREE
    EmbreeHemicube embree(model, size);
    fmt::print("{:g}: {:.2f} % of the pixels differ from Embree's\n", x,
               100 * differing(model, cubes[0], size, embree));
#endif
    Row row{.x = x};
    const auto least = [&](double& best, const auto& run) {
        best = std::min(best, milliseconds(run) / at_once);
    };
    for (int i = 0; i < options.repeats; ++i) {
        least(row.drawn, [&] { painters.draw(model, cubes); });
        least(row.whole, [&] { factors.from_points(points, 0); });
#ifdef GW_WITH_OSMESA
        least(row.llvmpipe, [&] {
            for (const radiosity::Hemicube& cube : cubes) peer.draw(cube);
        });
#endif
#ifdef GW_WITH_EMBREE
        least(row.embree, [&] {
            for (const radiosity::Hemicube& cube : cubes) embree.gather(cube);
        });
#endif
    }
    return row;
}

void report(const std::string& name, const std::string& label, const std::vector<Row>& rows,
            const Options& options) {
    plot::Plot plot{.title = "Time of a hemicube against " + label,
                    .command = fmt::format("bench_radiosity -o {} --threads {}",
                                           options.folder.string(), options.threads),
                    .x = {.label = label, .log = 2},
                    .y = {.label = "milliseconds", .log = 10}};
    fmt::print("\n{:<10}{:>10}{:>10}{:>14}{:>10}{:>10}{:>10}\n", name, "drawn", "whole", "llvmpipe",
               "ratio", "Embree", "ratio");
    const auto ratio = [](double peer, double ours) {
        return peer < 1e9 ? fmt::format("{:.2f}", peer / ours) : "-";
    };
    const auto time = [](double peer) { return peer < 1e9 ? fmt::format("{:.3f}", peer) : "-"; };
    for (const Row& r : rows)
        fmt::print("{:<10g}{:>10.3f}{:>10.3f}{:>14}{:>10}{:>10}{:>10}\n", r.x, r.drawn, r.whole,
                   time(r.llvmpipe), ratio(r.llvmpipe, r.drawn), time(r.embree),
                   ratio(r.embree, r.whole));
    for (const auto& [what, value] : {std::pair{"drawn and read", &Row::drawn},
                                      {"with scan and sum", &Row::whole},
                                      {"llvmpipe, drawn and read", &Row::llvmpipe},
                                      {"Embree, one ray a pixel", &Row::embree}}) {
        plot::Series line{.name = what, .points = {}};
        for (const Row& r : rows)
            if (r.*value < 1e9) line.points.push_back({r.x, r.*value});
        if (line.points.empty()) continue;
        fmt::print("  {}: grows as {}^{:.2f}\n", what, name, plot::power_law(line.points).exponent);
        plot.series.push_back(std::move(line));
    }
    std::fflush(stdout);
    if (options.folder.empty()) return;
    image::OutputSet files;
    files.make_folder(options.folder);
    files.add(options.folder / (name + ".svg")).write_text(plot::svg(plot));
    files.add(options.folder / (name + ".csv")).write_text(plot::csv(plot));
    files.commit();
}

/// Milliseconds for a hemicube in the mean over every 40th patch: drawn and read; scanned and
/// summed too.
struct Shares {
    double drawn = 0, whole = 0;
};

Shares shares_of(const radiosity::PixmapModel& model) {
    radiosity::FormFactors factors(model, {.threads = 1});
    radiosity::HemicubePainter painter(128);
    radiosity::IdBuffers buffers;
    Shares sum;
    std::size_t hemicubes = 0;
    for (std::size_t p = 0; p < model.patches.size(); p += 40) {
        const auto points = radiosity::points_of(model, model.patches[p]);
        hemicubes += points.size();
        sum.drawn += milliseconds([&] {
            for (const radiosity::ShootPoint& point : points)
                painter.draw(model,
                             radiosity::hemicube_at(point.position, point.normal, 30,
                                                    point.size / 64, 1.01 * model.extent, 128),
                             buffers);
        });
        sum.whole += milliseconds([&] { factors.from_patch(p); });
    }
    return {sum.drawn / double(hemicubes), sum.whole / double(hemicubes)};
}

/// [F] to 1 % unshot: seconds of processor time, and how they are shared.
void cornell() {
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/radiosity/cornell.toml").scene;
    radiosity::Solver solver(radiosity::make_model(scene, {.texels_per_unit = 64 / 559.2}),
                             {.form_factors = {.threads = 1}});
    int hemicubes = 0;
    const double all = milliseconds([&] {
        while (radiosity::books(solver.model(), solver.solution()).unshot_share() > 0.01)
            hemicubes += solver.shoot()->hemicubes;
    });
    const radiosity::PixmapModel& model = solver.model();
    const Shares shares = shares_of(model);
    fmt::print(
        "\nCornell box, {} texels, {} patches, to 1 % unshot: {} shots, {} hemicubes of 128, {:.1f} s on "
        "one thread\n  drawing {:.0f} %, scanning and summing {:.0f} %, the rest {:.0f} %\n",
        model.texel_count(), model.patches.size(), solver.solution().shots, hemicubes, all / 1000,
        100 * shares.drawn * hemicubes / all, 100 * (shares.whole - shares.drawn) * hemicubes / all,
        100 - 100 * shares.whole * hemicubes / all);
}

int run(const Options& options) {
    const char* const workers = std::getenv("LP_NUM_THREADS");
    fmt::print("threads: {}; llvmpipe's LP_NUM_THREADS: {}\n", options.threads,
               workers ? workers : "not set");
    const auto sweep = [&](const std::string& name, const std::string& label,
                           const std::vector<int>& values, const auto& row) {
        std::vector<Row> rows;
        for (const int v : values) rows.push_back(row(v));
        report(name, label, rows, options);
    };
    sweep("hemicube", "pixels across the hemicube", {32, 64, 128, 256, 512},
          [&](int v) { return measure(v, v, 12, 4, options); });
    sweep("texels", "texels", {4, 8, 16, 32, 64},
          [&](int v) { return measure(28.0 * v * v, 128, v, 4, options); });
    sweep("polygons", "triangles", {4, 16, 64, 128},
          [&](int v) { return measure(2.0 * v * v, 128, 12, v, options); });
    if (options.cornell) cornell();
    return 0;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    gw::bench::Options options;
    CLI::App app{
        "Hemicubes per second, beside llvmpipe and Embree.\nExample: bench_radiosity -o hemicubes --cornell"};
    app.add_option("-o,--output", options.folder, "folder of plots and their numbers");
    app.add_option("--repeats", options.repeats, "timed repeats")->check(CLI::Range(1, 1000));
    app.add_option("--threads", options.threads, "that draw, each its own hemicubes")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--cornell", options.cornell, "also the Cornell box to 1 % unshot");
    CLI11_PARSE(app, argc, argv);
    try {
        return gw::bench::run(options);
    } catch (const gw::Error& error) {
        fmt::print(stderr, "bench_radiosity: {}\n", error.what());
        return 1;
    }
}
