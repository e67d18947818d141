// Equation 5 [K4]: passes, item buffer, second rays.
#include "bench/folders/fig9.h"
#include "itembuffer/render.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

void eq5(benchmark::State& state) {
    const Ready r = ready("fig9.toml");
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    multipass::Options passes;
    passes.passes = itembuffer::passes_with_tracing(r.scene, multipass::Translucency::Sorted);
    for (auto _ : state) {
        itembuffer::render(*machine, r.scene, r.view, passes, {.threads = 1});
        machine->reset_passes();
    }
}
BENCHMARK(eq5)->Name("itembuffer/frame with its hierarchy")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gw::bench
