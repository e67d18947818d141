// Many small draws, on the machine and on Mesa's OpenGL in one run: bench_draws. Times are the
// processor's, the least of interleaved repeats; the pictures of both sides are compared.
#include "bench/draws/opengl.h"
#include "gw/machine.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace gw::draws {
namespace {

struct Options {
    std::vector<int> counts{500, 2000, 4000, 10000};
    int repeats = 5;
    bool alone = false;
    std::string only;
};

/// Milliseconds of processor time; the library's clock counts microseconds.
double time_of(const auto& run) {
    const auto now = [] {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
    };
    const double start = now();
    run();
    return now() - start;
}

/// The least of several times.
struct Least {
    double ms = 0;
    void add(double t) { ms = ms == 0 ? t : std::min(ms, t); }
};

struct Row {
    Least first, again, begin, list, arrays;
    double differing = 0;

    double theirs() const { return std::min({begin.ms, list.ms, arrays.ms}); }
};

/// Share of pixels that differ by more than 8 of 255 in a channel.
double differing(const Planes& ours, const std::vector<unsigned char>& theirs) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < ours.color.size(); ++i) {
        bool differs = false;
        for (std::size_t c = 0; c < 3; ++c)
            differs = differs || std::abs(int(ours.color[i][c]) - int(theirs[4 * i + c])) > 8;
        count += differs ? 1 : 0;
    }
    return double(count) / double(ours.color.size());
}

/// One number of draws of one kind; `make(shift)` gives the list.
Row measure(Machine& machine, OpenGl* gl, const std::vector<Quad>& quads, Own own, int repeats,
            const auto& make) {
    Row row;
    const auto draw = [&](const CommandList& list) {
        const double t = time_of([&] { machine.execute(list); });
        machine.reset_passes();
        return t;
    };
    for (int i = 0; i <= repeats; ++i) {  // the first round warms up
        const CommandList list = make(1e-3 * i / repeats);
        const double first = draw(list), again = draw(list);
        if (i == 0) continue;
        row.first.add(first);
        row.again.add(again);
    }
    if (!gl) return row;
    machine.execute(make(0));
    for (const Method method : {Method::Begin, Method::Arrays, Method::List}) {
        Least& least = method == Method::Begin  ? row.begin
                       : method == Method::List ? row.list
                                                : row.arrays;
        gl->prepare(quads, own, method);
        gl->run();
        for (int i = 0; i < repeats; ++i) least.add(time_of([&] { gl->run(); }));
    }
    row.differing = differing(machine.planes(), gl->picture());
    return row;
}

void print(const char* name, int count, const Row& r) {
    fmt::print("{:<26}{:>8}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>8.2f}{:>8.2f}{:>9.2f} %\n",
               name, count, r.first.ms, r.again.ms, r.begin.ms, r.list.ms, r.arrays.ms,
               r.theirs() / r.first.ms, r.theirs() / r.again.ms, 100 * r.differing);
    std::fflush(stdout);
}

void run(const Options& options) {
    const std::unique_ptr<Machine> machine = make_fast(vgx(), width, height, {.threads = 1});
    std::unique_ptr<OpenGl> gl;
    if (!options.alone) gl = std::make_unique<OpenGl>();
    fmt::print("{}, {}; milliseconds of processor time on one thread, the least of {}\n",
               gl ? gl->renderer() : "alone", simd_target(), options.repeats);
    fmt::print("{:<26}{:>8}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}{:>11}\n", "draws", "", "new",
               "again", "Begin", "list", "arrays", "ratio", "again", "pixels off");
    for (const int count : options.counts) {
        const Ours ours(count);
        const std::vector<Quad> field = quads(count);
        if (options.only.empty() || options.only == "merged")
            print("one merged mesh", count,
                  measure(*machine, gl.get(), field, Own::Nothing, options.repeats,
                          [&](double shift) { return ours.merged(shift); }));
        for (const Own own : every_own)
            if (options.only.empty() || options.only == name_of(own))
                print(name_of(own), count,
                      measure(*machine, gl.get(), field, own, options.repeats,
                              [&](double shift) { return ours.draws(own, shift); }));
    }
}

}  // namespace
}  // namespace gw::draws

int main(int argc, char** argv) {
    gw::draws::Options options;
    CLI::App app{"Many small draws, on the machine and on Mesa's OpenGL.\nExample: bench_draws"};
    app.add_option("--counts", options.counts, "numbers of draws")->check(CLI::Range(1, 1000000));
    app.add_option("--repeats", options.repeats, "timed repeats")->check(CLI::Range(1, 1000));
    app.add_option("--only", options.only, "one row, by its name");
    app.add_flag("--alone", options.alone, "only the machine, for a profiler");
    CLI11_PARSE(app, argc, argv);
    try {
        gw::draws::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_draws: {}\n", error.what());
        return 1;
    }
}
