// The machines: one multi-pass frame on each, and the cost of a digest.
#include "bench/folders/fig9.h"
#include "gw/machine.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

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

}  // namespace
}  // namespace gw::bench
