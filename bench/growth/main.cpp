// How the machine's time grows: bench_growth prints a table with fitted exponents and writes plots.
// With --largest it draws the largest frame once and prints the memory it took.
#include "bench/growth/scenes.h"
#include "bench/growth/sweeps.h"
#include "bench/peers/ours.h"
#include "gw/machine.h"
#include "image/output/output_file.h"
#include "study/plot/plot.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace gw::growth {
namespace {

struct Options {
    std::string scene = GW_SOURCE_DIR "/scenes/fig9.toml", folder = "build/growth", only;
    int repeats = 3;
    bool largest = false, scenes = false;
};

/// The least wall time of some runs after one that warms up, in milliseconds: other processes only
/// add. Every frame has another view.
double milliseconds(const Step& step, int repeats) {
    const peers::Frame frame = step.frame();
    const auto machine = make_fast(vgx(), frame.width, frame.height, {.threads = step.threads});
    CommandList list = peers::command_list(step.workload, frame);
    double least = 0;
    for (int i = 0; i <= repeats; ++i) {
        list = peers::moved(std::move(list));
        const auto start = std::chrono::steady_clock::now();
        machine->execute(list), machine->reset_passes();
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        if (i == 1 || took.count() < least) least = took.count();
    }
    return least;
}

/// One sweep's times, printed as they come.
std::vector<dvec2> measure(const Sweep& sweep, int repeats) {
    std::vector<dvec2> points;
    for (const Step& step : sweep.steps) {
        points.push_back({step.amount, milliseconds(step, repeats)});
        fmt::print("{:<10}{:>12.0f}{:>12.2f} ms\n", sweep.name, step.amount, points.back().y);
        std::fflush(stdout);
    }
    return points;
}

void print_law(const Sweep& sweep, const std::vector<dvec2>& points) {
    const dvec2 &first = points.front(), &last = points.back();
    fmt::print("{:<10}exponent {:.2f}; first {:.2f} ms, each more {:.3g} ms\n\n", sweep.name,
               plot::power_law(points).exponent, first.y, (last.y - first.y) / (last.x - first.x));
}

void write_plot(const Sweep& sweep, const std::vector<dvec2>& points, const Options& options) {
    const plot::Plot plot{
        .title = fmt::format("Time of a frame by {}", sweep.name),
        .caption = fmt::format("Fitted exponent {:.2f}.", plot::power_law(points).exponent),
        .command = fmt::format("build/release/bin/bench_growth --only {}", sweep.name),
        .x = {sweep.name, 2},
        .y = {"milliseconds", 10},
        .series = {{"measured", points}}};
    const std::filesystem::path base =
        std::filesystem::path(options.folder) / ("growth-" + sweep.name);
    image::write_file(base.string() + ".svg", plot::svg(plot));
    image::write_file(base.string() + ".csv", plot::csv(plot));
}

double user_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_utime.tv_sec) + double(usage.ru_utime.tv_usec) * 1e-6;
}

/// Processor time of reading each file of a sweep, printed with its exponent.
void read_scenes(const Options& options) {
    for (const SceneSweep& sweep : scene_sweeps()) {
        if (!options.only.empty() && sweep.name != options.only) continue;
        std::vector<dvec2> points;
        for (const double amount : sweep.amounts) {
            const std::filesystem::path file =
                std::filesystem::path(options.folder) / ("growth-" + sweep.file);
            image::write_file(file, sweep.text(int(amount)));
            const double start = user_seconds();
            read_swept(file.string());
            points.push_back({amount, (user_seconds() - start) * 1000});
            std::filesystem::remove(file);
            fmt::print("{:<20}{:>12.0f}{:>12.2f} ms\n", sweep.name, amount, points.back().y);
            std::fflush(stdout);
        }
        print_law({sweep.name, {}}, points);
        write_plot({sweep.name, {}}, points, options);
    }
}

void draw_largest(const Options& options) {
    const Step step = largest(options.scene);
    const double took = milliseconds(step, 1);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print(
        "{:.0f} triangles, 4096x4096 pixels, {} passes, {} threads: {:.0f} ms, {:.2f} GiB at most\n",
        step.amount, step.workload.passes.size() - 1, step.threads, took,
        double(usage.ru_maxrss) / (1024 * 1024));
}

void run(const Options& options) {
    if (options.largest) return draw_largest(options);
    std::filesystem::create_directories(options.folder);
    if (options.scenes) return read_scenes(options);
    for (const Sweep& sweep : sweeps(options.scene)) {
        if (!options.only.empty() && sweep.name != options.only) continue;
        const std::vector<dvec2> points = measure(sweep, options.repeats);
        print_law(sweep, points);
        write_plot(sweep, points, options);
    }
}

}  // namespace
}  // namespace gw::growth

int main(int argc, char** argv) {
    gw::growth::Options options;
    CLI::App app{
        "How the machine's time grows with triangles, pixels, passes, samples, lights, threads.\n"
        "Example: bench_growth --only passes"};
    app.add_option("--scene", options.scene, "whose geometry is drawn")->capture_default_str();
    app.add_option("-o,--output", options.folder, "folder for the plots")->capture_default_str();
    app.add_option("--only", options.only,
                   "one of triangles, pixels, passes, samples, lights, threads; with --scenes one "
                   "of its sweeps");
    app.add_option("--repeats", options.repeats, "timed repeats")->check(CLI::Range(1, 1000));
    app.add_flag("--scenes", options.scenes,
                 "time reading scene files: boxes, named-lights, materials, numbers, groups, "
                 "smoothing-groups, faces-at-a-point, vertices-at-a-point");
    app.add_flag("--largest", options.largest, "draw the largest frame and print its memory");
    CLI11_PARSE(app, argc, argv);
    try {
        gw::growth::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_growth: {}\n", error.what());
        return 1;
    }
}
