// Reading a scene with its models.
#include "scene/read_scene.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

void read(benchmark::State& state, const char* file) {
    for (auto _ : state) benchmark::DoNotOptimize(scene::read_scene(file));
}
BENCHMARK_CAPTURE(read, fig9, GW_SOURCE_DIR "/scenes/fig9.toml")
    ->Name("scene/read/fig9")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, cornell, GW_SOURCE_DIR "/scenes/cornell.toml")->Name("scene/read/cornell");

}  // namespace
}  // namespace gw::bench
