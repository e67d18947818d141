// The machine and Mesa's OpenGL on the same frames, in one run: bench_peers. scripts/compare-peers
// runs it for each driver and number of threads. Times are medians of interleaved repeats; the
// pictures of both sides are compared.
#include "bench/peers/opengl.h"
#include "bench/peers/ours.h"
#include "gw/machine.h"
#include "image/output/output_file.h"
#include "image/plot/plot.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace gw::peers {
namespace {

struct Options {
    std::string scene = GW_SOURCE_DIR "/scenes/fig9.toml", json, only;
    int repeats = 7, threads = 1;
    std::string plot;
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

/// Share of pixels that differ by more than `bound` of 255 in any channel of R, G, B.
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
    /// first: ours if the previous frame had another view
    Time ours, first, buffers, lists, strips;
    double differing = 0;

    Time theirs() const {
        return std::min({buffers, lists, strips},
                        [](const Time& a, const Time& b) { return a.wall < b.wall; });
    }
    double ratio() const { return theirs().wall / ours.wall; }
    double first_ratio() const { return theirs().wall / first.wall; }
};

/// The two windows' machines and contexts.
struct Window {
    Frame frame;
    std::unique_ptr<Machine> machine;
    OpenGl buffers, lists, strips;

    Window(Frame f, int threads)
        : frame(std::move(f)),
          machine(make_fast(vgx(), frame.width, frame.height, {.threads = threads})),
          buffers(frame, Store::Buffers),
          lists(frame, Store::Lists),
          strips(frame, Store::Strips) {}
};

Row measure(const Workload& w, Window& window, const Options& options) {
    const CommandList list = command_list(w, window.frame), other = moved(list);
    const auto draw = [&](const CommandList& l) {
        return time_of([&] { window.machine->execute(l), window.machine->reset_passes(); });
    };
    const auto peer = [&](OpenGl& gl) {
        return options.alone ? Time{} : time_of([&] { gl.run(w); });
    };
    std::vector<Time> ours, first, buffers, lists, strips;
    for (int i = 0; i <= options.repeats; ++i) {  // the first time round warms up
        draw(other);
        const Time a = draw(list), again = draw(list);
        const Time b = peer(window.buffers), c = peer(window.lists), d = peer(window.strips);
        if (i == 0) continue;
        first.push_back(a), ours.push_back(again);
        buffers.push_back(b), lists.push_back(c), strips.push_back(d);
    }
    const double differs =
        options.alone || (w.passes.front().shade == Shade::None && w.passes.size() == 1)
            ? 0
            : differing(window.machine->planes(), window.lists.picture(), 8);
    return {&w,     median(ours), median(first), median(buffers), median(lists), median(strips),
            differs};
}

void print_row(const Row& r) {
    fmt::print(
        "{:<3}{:<33}{:>8.2f}{:>8.2f}{:>8.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>7.2f}{:>7.2f}{:>8.1f}{:>9.2f} "
        "%\n",
        r.workload->key, r.workload->name, r.first.wall, r.ours.wall, r.ours.cpu, r.buffers.wall,
        r.lists.wall, r.strips.wall, r.theirs().cpu, r.first_ratio(), r.ratio(), r.workload->wanted,
        100 * r.differing);
    std::fflush(stdout);
}

nlohmann::json to_json(const Row& r) {
    return {{"key", r.workload->key},         {"name", r.workload->name},
            {"ours_ms", r.ours.wall},         {"ours_cpu_ms", r.ours.cpu},
            {"first_ms", r.first.wall},       {"first_cpu_ms", r.first.cpu},
            {"first_ratio", r.first_ratio()}, {"buffers_ms", r.buffers.wall},
            {"lists_ms", r.lists.wall},       {"strips_ms", r.strips.wall},
            {"peer_cpu_ms", r.theirs().cpu},  {"ratio", r.ratio()},
            {"wanted", r.workload->wanted},   {"pixels_differing", r.differing}};
}

/// How often our frames fit into the peer's, by workload.
plot::Plot ratios(const std::vector<Row>& rows, const std::string& renderer,
                  const Options& options) {
    plot::Series first{"a view's first frame", {}}, again{"the same view again", {}},
        wanted{"wanted", {}, false};
    for (const Row& r : rows) {
        const double place = 1 + r.workload->key[0] - 'a';
        first.points.push_back({place, r.first_ratio()}),
            again.points.push_back({place, r.ratio()});
        wanted.points.push_back({place, r.workload->wanted});
    }
    return {
        .title = fmt::format("The machine beside {}, {} thread(s)", renderer, options.threads),
        .caption = "The peer's time over ours, pictures compared. Workloads 1 to 14 are a to n.",
        .command = "scripts/compare-peers",
        .x = {"workload"},
        .y = {"ratio of times", 2},
        .series = {first, again, wanted}};
}

int run(const Options& options) {
    for (const std::string& file : {options.json, options.plot})
        if (!file.empty()) image::check_target(file);
    Window scene(scene_frame(options.scene.c_str()), options.threads);
    Window fill(fill_frame(), options.threads);
    const std::string renderer = scene.lists.renderer();
    fmt::print("{}, {} thread(s), {}; milliseconds, medians of {}\n", renderer, options.threads,
               simd_target(), options.repeats);
    fmt::print("{:<36}{:>8}{:>8}{:>8}{:>9}{:>9}{:>9}{:>9}{:>7}{:>7}{:>8}{:>11}\n", "workload",
               "first", "again", "cpu", "buffers", "lists", "strips", "cpu", "ratio", "again",
               "wanted", "pixels off");
    nlohmann::json json = nlohmann::json::array();
    std::vector<Row> rows;
    for (const Workload& w : workloads()) {
        if (!options.only.empty() && options.only.find(w.key) == std::string::npos) continue;
        rows.push_back(measure(w, w.fill ? fill : scene, options));
        print_row(rows.back());
        json.push_back(to_json(rows.back()));
    }
    if (!options.plot.empty())
        image::write_file(options.plot, plot::svg(ratios(rows, renderer, options)));
    if (options.json.empty()) return 0;
    const nlohmann::json table{{"renderer", renderer},
                               {"threads", options.threads},
                               {"simd", simd_target()},
                               {"repeats", options.repeats},
                               {"workloads", json}};
    image::write_file(options.json, table.dump(2) + "\n");
    return 0;
}

}  // namespace
}  // namespace gw::peers

int main(int argc, char** argv) {
    gw::peers::Options options;
    CLI::App app{
        "The machine and Mesa's OpenGL on the same frames, in one run.\nExample: bench_peers --only abcd"};
    app.add_option("--scene", options.scene, "the scene of workloads a to h")
        ->capture_default_str();
    app.add_option("--only", options.only, "letters of the workloads to run");
    app.add_option("--repeats", options.repeats, "timed repeats")->check(CLI::Range(1, 1000));
    app.add_option("--threads", options.threads, "of the machine")->check(CLI::Range(1, 256));
    CLI::Option* alone = app.add_flag("--alone", options.alone, "only the machine, for a profiler");
    app.add_option("--json", options.json, "write the table to this file too");
    app.add_option("--plot", options.plot, "draw the ratios into this SVG file")->excludes(alone);
    CLI11_PARSE(app, argc, argv);
    try {
        return gw::peers::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_peers: {}\n", error.what());
        return 1;
    }
}
