// How time and memory grow: bench_growth prints a table with fitted exponents and writes plots.
// With --largest it draws the largest frame once and prints its peak memory.
#include "bench/growth/memory.h"
#include "bench/growth/sweep.h"
#include "gw/error.h"
#include "image/output/output_file.h"
#include "image/plot/plot.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>

namespace gw::growth {

double least_time(int repeats, const std::function<void()>& run,
                  const std::function<void()>& set_up) {
    double least = 0;
    for (int i = 0; i <= repeats; ++i) {
        if (set_up) set_up();
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t worked = std::clock();
        run();
        const std::chrono::duration<double, std::milli> wall =
            std::chrono::steady_clock::now() - start;
        const double took =
            std::min(wall.count(), 1000.0 * double(std::clock() - worked) / CLOCKS_PER_SEC);
        if (i <= 1 || took < least) least = took;
        if (i == 0 && took > 1000) break;  // long runs are their own warming up
    }
    return least;
}

namespace {

struct Options {
    std::string scene = GW_SOURCE_DIR "/scenes/fig9.toml", folder = "build/growth";
    std::vector<std::string> only;
    int repeats = 3;
    double limit = 60;
    bool largest = false;
    int frames = 0;  ///< of a long run; 0: none
};

struct Cost {
    double milliseconds = 0, megabytes = 0;  ///< peak memory
};

/// In a child process. Throws Error if that fails.
Cost cost_of(const Step& step, int repeats) {
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) throw Error("no pipe to a measured process");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw Error("no process for a measurement");
    if (child == 0) {
        double took = 0;
        try {
            took = step.milliseconds(repeats);
        } catch (const std::exception& error) {
            fmt::print(stderr, "bench_growth: {}\n", error.what());
            std::fflush(stderr);
            _exit(1);
        }
        const bool written = write(pipe_ends[1], &took, sizeof took) == sizeof took;
        _exit(written ? 0 : 1);
    }
    close(pipe_ends[1]);
    Cost cost;
    const bool got =
        read(pipe_ends[0], &cost.milliseconds, sizeof cost.milliseconds) == sizeof(double);
    close(pipe_ends[0]);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (!got || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw Error("a measured process failed");
    cost.megabytes = double(usage.ru_maxrss) / 1024;
    return cost;
}

struct Measured {
    std::vector<dvec2> time, memory;
};

/// As much longer as the last step was than the one before.
double next_time(const std::vector<dvec2>& time) {
    if (time.size() < 2) return time.empty() ? 0 : time.back().y;
    return time.back().y * std::max(1.0, time.back().y / time[time.size() - 2].y);
}

/// Runs one sweep and prints its steps. Stops if the next step would take longer than the limit.
Measured measure(const Sweep& sweep, const Options& options) {
    Measured measured;
    for (const Step& step : sweep.steps) {
        if (next_time(measured.time) > 1000 * options.limit) {
            fmt::print("{:<16}{:>12.0f}   not run: longer than {:.0f} s\n", sweep.name, step.amount,
                       options.limit);
            break;
        }
        const Cost cost = cost_of(step, options.repeats);
        measured.time.push_back({step.amount, std::max(cost.milliseconds, 1e-4)});
        measured.memory.push_back({step.amount, cost.megabytes});
        fmt::print("{:<16}{:>12.0f}{:>14.3f} ms{:>10.0f} MB\n", sweep.name, step.amount,
                   cost.milliseconds, cost.megabytes);
        std::fflush(stdout);
    }
    return measured;
}

/// Of the largest amounts, which make constant work negligible; 0: too few.
double last_exponent(const std::vector<dvec2>& points) {
    if (points.size() < 2) return 0;
    const auto from = points.end() - std::min<std::ptrdiff_t>(3, std::ptrdiff_t(points.size()));
    return plot::power_law({from, points.end()}).exponent;
}

void print_law(const Sweep& sweep, const Measured& measured) {
    if (measured.time.size() < 2) return;
    fmt::print(
        "{:<16}exponent {:.2f}, of the last three {:.2f}; memory of the last three {:.2f}\n\n",
        sweep.name, plot::power_law(measured.time).exponent, last_exponent(measured.time),
        last_exponent(measured.memory));
}

void write_plot(const Sweep& sweep, const Measured& measured, const Options& options) {
    if (measured.time.size() < 2) return;
    plot::Plot plot;
    plot.title = fmt::format("{} by {}", sweep.name, sweep.quantity);
    plot.caption =
        fmt::format("Exponent of the last three points {:.2f}.", last_exponent(measured.time));
    plot.command = fmt::format("build/release/bin/bench_growth --only {}", sweep.name);
    plot.x = {sweep.quantity, sweep.steps.back().amount > 1000 ? 10 : 2};
    plot.y = {"milliseconds; MB", 10};
    plot.series = {{"milliseconds", measured.time}, {"MB at the peak", measured.memory}};
    const std::filesystem::path base =
        std::filesystem::path(options.folder) / ("growth-" + sweep.name);
    image::write_file(base.string() + ".svg", plot::svg(plot));
    image::write_file(base.string() + ".csv", plot::csv(plot));
}

void draw_largest(const Options& options) {
    const Step step = largest_frame(options.scene);
    const Cost cost = cost_of(step, 1);
    fmt::print("{:.0f} triangles, 4096x4096 pixels, 64 passes, 2 threads: {:.0f} ms, {:.2f} GiB\n",
               step.amount, cost.milliseconds, cost.megabytes / 1024);
}

std::vector<Sweep> all_sweeps(const std::string& scene) {
    std::vector<Sweep> all;
    for (auto&& family : {machine_sweeps(scene), draw_sweeps(), scene_sweeps(), reader_sweeps()})
        all.insert(all.end(), family.begin(), family.end());
    return all;
}

bool wanted(const std::string& name, const std::vector<std::string>& only) {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
}

/// The memory of a run of many frames, with a plot.
void run_long(const Options& options) {
    const std::vector<dvec2> samples = memory_by_frame(options.frames, [&](int frame) {
        if (frame * 10LL % options.frames == 0)
            fmt::print(stderr, "{} of {} frames\n", frame, options.frames);
    });
    const dvec2 &early = samples[samples.size() / 10], &last = samples.back();
    fmt::print("{:.0f} frames: {:.1f} MB; {:.0f} frames: {:.1f} MB\n", early.x, early.y, last.x,
               last.y);
    plot::Plot plot;
    plot.title = "Memory by frames";
    plot.caption = "Meshes and textures change in every frame.";
    plot.command = fmt::format("build/release/bin/bench_growth --memory {}", options.frames);
    plot.x.label = "frames";
    plot.y.label = "megabytes of the process";
    plot.series.push_back({"measured", samples});
    const std::string base = options.folder + "/memory";
    image::write_file(base + ".svg", plot::svg(plot));
    image::write_file(base + ".csv", plot::csv(plot));
}

void run(const Options& options) {
    if (options.largest) return draw_largest(options);
    std::filesystem::create_directories(options.folder);
    if (options.frames != 0) return run_long(options);
    for (const Sweep& sweep : all_sweeps(options.scene)) {
        if (!wanted(sweep.name, options.only)) continue;
        const Measured measured = measure(sweep, options);
        print_law(sweep, measured);
        write_plot(sweep, measured, options);
    }
}

std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const Sweep& sweep : all_sweeps("")) names.push_back(sweep.name);
    return names;
}

}  // namespace
}  // namespace gw::growth

int main(int argc, char** argv) {
    gw::growth::Options options;
    CLI::App app{
        "How time and memory grow with triangles, pixels, passes, objects, lights ...\n"
        "Example: bench_growth --only passes --only scene-draw"};
    app.add_option("--scene", options.scene, "whose geometry the machine's sweeps draw")
        ->capture_default_str();
    app.add_option("-o,--output", options.folder, "folder for the plots")->capture_default_str();
    app.add_option("--only", options.only, "only these sweeps")
        ->check(CLI::IsMember(gw::growth::names()));
    app.add_option("--repeats", options.repeats, "timed repeats")->check(CLI::Range(1, 1000));
    app.add_option("--limit", options.limit, "seconds: a sweep ends before a longer run")
        ->capture_default_str();
    app.add_flag("--largest", options.largest, "draw the largest frame and print its memory");
    app.add_option("--memory", options.frames, "draw this many frames and plot the memory")
        ->check(CLI::Range(100, 100000000));
    CLI11_PARSE(app, argc, argv);
    try {
        gw::growth::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_growth: {}\n", error.what());
        return 1;
    }
}
