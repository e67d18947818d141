// bench_scale -o DIR: large scenes. A sheet of waves of 10,000 to 5,000,000 triangles, written as
// OBJ, drawn by `gw render` as a user would: by passes with shadow volumes, by passes with shadow
// maps, with an item buffer and traced reflections, by the ordinary ray tracer. Measures seconds of
// processor time, peak memory, and the speed of reading the OBJ, compared with tinyobjloader if it
// is installed. Writes DIR/seconds.svg, memory.svg and their numbers. Does not compare pictures.
#include "apps/command/peak_memory.h"
#include "bench/scale/obj_file.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/plot/plot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

extern char** environ;

namespace gw::bench {
namespace {

struct Options {
    std::filesystem::path folder;
    double up_to = 5e6;
    int repeats = 3;
    bool read_only = false;
};

struct Renderer {
    std::string name, shadow;
    int illum = 2;
    std::vector<std::string> words;
};

const std::vector<Renderer>& renderers() {
    static const std::vector<Renderer> all{
        {"passes, shadow volumes", "volume", 2, {}},
        {"passes, shadow maps", "map", 2, {}},
        {"item buffer and rays", "volume", 3, {}},
        {"ordinary ray tracer", "volume", 3, {"--renderer", "raytrace"}},
    };
    return all;
}

std::string scene_text(const Renderer& renderer) {
    return fmt::format(R"(name = "sheet"
[camera]
eye = [0, 4, 9]
at = [0, 0, 0]
fov = 40
[[light]]
name = "lamp"
position = [-5, 6, 4]
Ia = 0.2
Id = 0.7
Is = 0.6
shadow = "{}"
[material.water]
Ka = 0.3
Kd = 0.6
Ks = 0.3
Ns = 40
illum = {}
[[object]]
name = "sheet"
file = "sheet.obj"
material = "water"
)",
                       renderer.shadow, renderer.illum);
}

struct Used {
    double seconds = 0, megabytes = 0;
};

/// Runs a program to its end. Throws Error if it fails.
Used run_program(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
        throw Error(words[0], 0, "cannot be run; expected the command gw, built");
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error(words[0], 0, "failed");
    const auto seconds = [](const timeval& t) {
        return double(t.tv_sec) + 1e-6 * double(t.tv_usec);
    };
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
            double(peak_memory(usage)) / (1 << 20)};
}

Used draw(const Renderer& renderer, const std::filesystem::path& folder) {
    const std::filesystem::path scene = folder / "sheet.toml";
    image::OutputSet files;
    files.add(scene).write_text(scene_text(renderer));
    files.commit();
    std::vector<std::string> words{
        GW_BIN_DIR "/gw", "render",  scene,       "-o", folder / "sheet.png",
        "--size",         "640x480", "--threads", "1",  "--quiet"};
    words.insert(words.end(), renderer.words.begin(), renderer.words.end());
    return run_program(words);
}

void write_plot(const Options& options, const std::string& name, const std::string& label,
                const std::vector<plot::Series>& series) {
    const plot::Plot plot{.title = label + " against triangles",
                          .command = "bench_scale -o " + options.folder.string(),
                          .x = {.label = "triangles", .log = 10},
                          .y = {.label = label, .log = 10},
                          .series = series};
    image::OutputSet files;
    files.add(options.folder / (name + ".svg")).write_text(plot::svg(plot));
    files.add(options.folder / (name + ".csv")).write_text(plot::csv(plot));
    files.commit();
}

/// Beyond the first of the series; 0 for that.
double bytes_a_triangle(const plot::Series& memory, double triangles, const Used& used) {
    if (memory.points.empty()) return 0;
    const dvec2& first = memory.points.front();
    return (used.megabytes - first.y) * (1 << 20) / (triangles - first.x);
}

void draw_all(const Options& options) {
    std::vector<plot::Series> seconds, memory;
    for (const Renderer& r : renderers()) {
        seconds.push_back({.name = r.name, .points = {}});
        memory.push_back({.name = r.name, .points = {}});
    }
    fmt::print("{:<34}{:>12}{:>10}{:>10}{:>18}\n", "drawn from the OBJ, 640x480", "triangles",
               "seconds", "MB", "bytes a triangle*");
    for (const double wanted : {1e4, 1e5, 1e6, 5e6}) {
        if (wanted > options.up_to) break;
        const double triangles = double(write_sheet(options.folder / "sheet.obj", wanted, false));
        for (std::size_t i = 0; i < renderers().size(); ++i) {
            const Used used = draw(renderers()[i], options.folder);
            fmt::print("{:<34}{:>12.0f}{:>10.2f}{:>10.0f}{:>18.0f}\n", renderers()[i].name,
                       triangles, used.seconds, used.megabytes,
                       bytes_a_triangle(memory[i], triangles, used));
            std::fflush(stdout);
            seconds[i].points.push_back({triangles, used.seconds});
            memory[i].points.push_back({triangles, used.megabytes});
        }
    }
    fmt::print("* beyond the smallest scene, which includes the program itself\n");
    write_plot(options, "seconds", "seconds of processor time", seconds);
    write_plot(options, "memory", "peak memory, MB", memory);
}

void read_all(const Options& options) {
    fmt::print("\n{:<34}{:>12}{:>8}{:>14}{:>22}{:>8}\n", "OBJ read", "triangles", "MB",
               "ours, MB/s", "tinyobjloader, MB/s", "ratio");
    for (const bool full : {false, true})
        for (const double wanted : {1e5, 1e6, 5e6}) {
            if (wanted > options.up_to) continue;
            const std::filesystem::path file = options.folder / "sheet.obj";
            const std::size_t triangles = write_sheet(file, wanted, full);
            const double megabytes = double(std::filesystem::file_size(file)) / 1e6;
            double ours = 1e9, theirs = 1e9;
            for (int i = 0; i < options.repeats; ++i) {
                ours = std::min(ours, read_ours(file));
                theirs = std::min(theirs, read_tinyobj(file));
            }
            fmt::print("{:<34}{:>12}{:>8.0f}{:>14.0f}{:>22.0f}{:>8.2f}\n",
                       full ? "v, vt, vn" : "v; normals and vertices made", triangles, megabytes,
                       megabytes / ours, theirs > 0 ? megabytes / theirs : 0, theirs / ours);
            std::fflush(stdout);
        }
}

int run(const Options& options) {
    image::OutputSet files;
    files.make_folder(options.folder);
    files.commit();
    if (!options.read_only) draw_all(options);
    read_all(options);
    for (const char* name : {"sheet.obj", "sheet.toml", "sheet.png"})
        std::filesystem::remove(options.folder / name);
    return 0;
}

}  // namespace
}  // namespace gw::bench

int main(int argc, char** argv) {
    gw::bench::Options options;
    CLI::App app{
        "Large scenes: seconds, memory, and OBJ read.\nExample: bench_scale -o scale --up-to 1e6"};
    app.add_option("-o,--output", options.folder, "Folder of the plots and their numbers")
        ->required();
    app.add_option("--up-to", options.up_to, "The most triangles of a sheet");
    app.add_option("--repeats", options.repeats, "Timed readings, of which the best counts")
        ->check(CLI::Range(1, 100));
    app.add_flag("--read", options.read_only, "Only the reading of OBJ");
    CLI11_PARSE(app, argc, argv);
    try {
        return gw::bench::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_scale: {}\n", error.what());
        return 1;
    }
}
