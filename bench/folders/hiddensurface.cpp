// Every hidden-surface algorithm [L] on one scene.
#include "bench/folders/fig9.h"
#include "hiddensurface/run/algorithm.h"
#include "hiddensurface/run/steps.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

void solve(benchmark::State& state, const hiddensurface::Algorithm& algorithm) {
    const Ready r = ready("hidden/solids.toml");
    const hiddensurface::Input input = hiddensurface::make_input(r.scene, r.view, vgx());
    for (auto _ : state) {
        hiddensurface::StepLog log;
        benchmark::DoNotOptimize(algorithm.run(input, log));
    }
}

[[maybe_unused]] const bool registered = [] {
    for (const hiddensurface::Algorithm& algorithm : hiddensurface::algorithms())
        benchmark::RegisterBenchmark(
            ("hiddensurface/" + algorithm.name).c_str(),
            [&algorithm](benchmark::State& state) { solve(state, algorithm); })
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace gw::bench
