// The machine and Mesa's OpenGL on the same frames, in one run: bench_peers. scripts/compare-peers runs it
// for each driver and number of threads. Times are medians of interleaved repeats; the pictures of both sides
// are compared.
#include "bench/peers/opengl.h"
#include "bench/peers/ours.h"
#include "gw/machine.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace gw::peers {
namespace {

struct Options {
    std::string scene = GW_SOURCE_DIR "/scenes/fig9.toml", json, only;
    int repeats = 7, threads = 1;
    bool alone = false;
};

/// Wall and processor time of one call, in milliseconds.
struct Time {
    double wall = 0, cpu = 0;
};
Time time_of(const auto& run) {
    const std::clock_t cpu = std::clock();
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    return {wall.count(), 1000.0 * double(std::clock() - cpu) / CLOCKS_PER_SEC};
}

Time median(std::vector<Time> times) {
    const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end(),
                     [](const Time& a, const Time& b) { return a.wall < b.wall; });
    return *middle;
}

/// Share of pixels that differ by more than `bound` of 255 in some channel of R, G, B.
double differing(const Planes& ours, const std::vector<unsigned char>& theirs, int bound) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < ours.color.size(); ++i) {
        bool differs = false;
        for (std::size_t c = 0; c < 3; ++c)
            differs = differs || std::abs(int(ours.color[i][c]) - int(theirs[4 * i + c])) > bound;
        count += differs ? 1 : 0;
    }
    return double(count) / double(ours.color.size());
}

/// One workload's row.
struct Row {
    const Workload* workload = nullptr;
    Time ours, buffers, lists;
    double differing = 0;

    const Time& theirs() const { return buffers.wall < lists.wall ? buffers : lists; }
    double ratio() const { return theirs().wall / ours.wall; }
};

/// The two windows' machines and contexts.
struct Window {
    Frame frame;
    std::unique_ptr<Machine> machine;
    OpenGl buffers, lists;

    Window(Frame f, int threads)
        : frame(std::move(f)),
          machine(make_fast(vgx(), frame.width, frame.height, {.threads = threads})),
          buffers(frame, Store::Buffers),
          lists(frame, Store::Lists) {}
};

Row measure(const Workload& w, Window& window, const Options& options) {
    const CommandList list = command_list(w, window.frame);
    std::vector<Time> ours, buffers, lists;
    for (int i = 0; i <= options.repeats; ++i) {  // the first time round warms up
        const Time a = time_of([&] { window.machine->execute(list), window.machine->reset_passes(); });
        const Time b = options.alone ? Time{} : time_of([&] { window.buffers.run(w); });
        const Time c = options.alone ? Time{} : time_of([&] { window.lists.run(w); });
        if (i == 0) continue;
        ours.push_back(a), buffers.push_back(b), lists.push_back(c);
    }
    const double differs = options.alone || (w.passes.front().shade == Shade::None && w.passes.size() == 1)
                               ? 0
                               : differing(window.machine->planes(), window.lists.picture(), 8);
    return {&w, median(ours), median(buffers), median(lists), differs};
}

void print_row(const Row& r) {
    fmt::print("{:<3}{:<36}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>8.2f}{:>8.1f}{:>9.2f} %\n",
               r.workload->key, r.workload->name, r.ours.wall, r.ours.cpu, r.buffers.wall, r.lists.wall,
               r.theirs().cpu, r.ratio(), r.workload->wanted, 100 * r.differing);
    std::fflush(stdout);
}

nlohmann::json to_json(const Row& r) {
    return {{"key", r.workload->key},         {"name", r.workload->name},     {"ours_ms", r.ours.wall},
            {"ours_cpu_ms", r.ours.cpu},      {"buffers_ms", r.buffers.wall}, {"lists_ms", r.lists.wall},
            {"peer_cpu_ms", r.theirs().cpu},  {"ratio", r.ratio()},           {"wanted", r.workload->wanted},
            {"pixels_differing", r.differing}};
}

int run(const Options& options) {
    Window scene(scene_frame(options.scene.c_str()), options.threads);
    Window fill(fill_frame(), options.threads);
    const std::string renderer = scene.lists.renderer();
    fmt::print("{}, {} thread(s), {}; milliseconds, medians of {}\n", renderer, options.threads,
               simd_target(), options.repeats);
    fmt::print("{:<39}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}{:>11}\n", "workload", "ours", "cpu", "buffers",
               "lists", "cpu", "ratio", "wanted", "pixels off");
    nlohmann::json rows = nlohmann::json::array();
    for (const Workload& w : workloads()) {
        if (!options.only.empty() && options.only.find(w.key) == std::string::npos) continue;
        const Row row = measure(w, w.fill ? fill : scene, options);
        print_row(row);
        rows.push_back(to_json(row));
    }
    if (options.json.empty()) return 0;
    std::ofstream(options.json) << nlohmann::json{{"renderer", renderer},
                                                  {"threads", options.threads},
                                                  {"simd", simd_target()},
                                                  {"repeats", options.repeats},
                                                  {"workloads", rows}}
                                       .dump(2)
                                << '\n';
    return 0;
}

}  // namespace
}  // namespace gw::peers

int main(int argc, char** argv) {
    gw::peers::Options options;
    CLI::App app{
        "The machine and Mesa's OpenGL on the same frames, in one run.\nExample: bench_peers --only abcd"};
    app.add_option("--scene", options.scene, "the scene of workloads a to h")->capture_default_str();
    app.add_option("--only", options.only, "letters of the workloads to run");
    app.add_option("--repeats", options.repeats, "timed repeats")->check(CLI::Range(1, 1000));
    app.add_option("--threads", options.threads, "of the machine")->check(CLI::Range(1, 256));
    app.add_flag("--alone", options.alone, "only the machine, for a profiler");
    app.add_option("--json", options.json, "write the table to this file too");
    CLI11_PARSE(app, argc, argv);
    return gw::peers::run(options);
}
