// Making a frame's commands: passes, shadow volumes.
#include "bench/folders/fig9.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

void commands(benchmark::State& state) {
    const Ready scene = ready("fig9.toml");
    for (auto _ : state) benchmark::DoNotOptimize(frame(scene));
}
BENCHMARK(commands)->Name("multipass/commands of fig9")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gw::bench
