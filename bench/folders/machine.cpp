// The machine and its recordings: gw, inspect.
#include "gw/machine.h"
#include "bench/folders/fig9.h"
#include "inspect/recording/recording.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

// The machines: one multi-pass frame on each, and the cost of a digest.

void run(benchmark::State& state, Machine& machine, CommandList list) {
    for (auto _ : state) {
        machine.execute(list);
        machine.reset_passes();
    }
}

void fast_frame(benchmark::State& state) {
    run(state, *make_fast(vgx(), width, height, {.threads = int(state.range(0))}),
        frame(ready("fig9.toml")));
}
BENCHMARK(fast_frame)
    ->Name("gw/frame/threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void reference_frame(benchmark::State& state) {
    run(state, *make_reference(vgx(), width, height), frame(ready("fig9.toml")));
}
BENCHMARK(reference_frame)
    ->Name("gw/frame/reference")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

void digested_frame(benchmark::State& state) {
    CommandList list = frame(ready("fig9.toml"));
    for (Command& command : list.commands)
        if (auto* pass = std::get_if<BeginPass>(&command)) pass->digests = all_planes;
    run(state, *make_fast(vgx(), width, height, {.threads = 1}), list);
}
BENCHMARK(digested_frame)
    ->Name("gw/frame/with digests of all passes")
    ->Unit(benchmark::kMillisecond);

// Recordings: writing, reading, playing pass by pass.

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
