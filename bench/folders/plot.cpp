// A plot of a thousand points.
#include "study/plot/plot.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

void svg(benchmark::State& state) {
    plot::Plot plot{.title = "A parabola",
                    .command = "bench_folders",
                    .x = {.label = "x", .log = 0},
                    .y = {.label = "y", .log = 0}};
    plot::Series line{.name = "x^2", .points = {}};
    for (int i = 0; i < 1000; ++i) line.points.push_back({double(i), double(i) * i});
    plot.series.push_back(line);
    for (auto _ : state) benchmark::DoNotOptimize(plot::svg(plot));
}
BENCHMARK(svg)->Name("plot/svg")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gw::bench
