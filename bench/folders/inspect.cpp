// Recordings: writing, reading, playing pass by pass.
#include "bench/folders/fig9.h"
#include "inspect/recording/recording.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

inspect::Recording recording() {
    inspect::Recording r;
    r.profile = vgx();
    r.width = width;
    r.height = height;
    r.lists.push_back(frame(ready("fig9.toml")));
    return r;
}

void encode(benchmark::State& state) {
    const inspect::Recording r = recording();
    for (auto _ : state) benchmark::DoNotOptimize(inspect::encode(r));
}
BENCHMARK(encode)->Name("inspect/encode")->Unit(benchmark::kMillisecond);

void decode(benchmark::State& state) {
    const std::vector<std::uint8_t> bytes = inspect::encode(recording());
    for (auto _ : state) benchmark::DoNotOptimize(inspect::decode(bytes));
    state.SetBytesProcessed(std::int64_t(state.iterations()) * std::int64_t(bytes.size()));
}
BENCHMARK(decode)->Name("inspect/decode")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gw::bench
