// The same frame on both machines: bench_machine [SCENE]. The ratio of the times is the figure in
// docs/exactness.md. Does not compare with other renderers.
#include "image/textures.h"
#include "multipass/driver.h"
#include "scene/fit.h"
#include "scene/read_scene.h"

#include <benchmark/benchmark.h>

#include <cstdio>

namespace {

constexpr int width = 640, height = 480;

/// A scene ready to draw.
struct Frame {
    gw::scene::Scene scene;
    gw::CommandList list;
    gw::CommandList first_pass;

    explicit Frame(const char* path) : scene(gw::scene::read_scene(path).scene) {
        gw::image::load_textures(scene);
        gw::scene::add_defaults(scene, width, height);
        const gw::scene::View view = gw::scene::make_view(scene, width, height);
        const auto passes = gw::multipass::passes_for(scene, gw::multipass::Renderer::Multipass);
        list = gw::multipass::frame_list(scene, view, passes, scene.background);
        for (const gw::Command& command : list.commands) {
            if (std::holds_alternative<gw::BeginPass>(command) && !first_pass.commands.empty() &&
                std::get<gw::BeginPass>(command).name != "depth")
                break;
            first_pass.add(command);
        }
    }
};

void run(benchmark::State& state, gw::Machine& machine, const gw::CommandList& list) {
    for (auto _ : state) {
        machine.execute(list);
        machine.reset_passes();
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const Frame frame(argc > 1 ? argv[1] : GW_SOURCE_DIR "/scenes/fig9.toml");
    const auto add = [&](const char* name, const gw::CommandList& list, auto make) {
        benchmark::RegisterBenchmark(name,
                                     [&list, make](benchmark::State& state) {
                                         const auto machine = make();
                                         run(state, *machine, list);
                                     })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    const auto fast = [](int threads) {
        return [threads] { return gw::make_fast(gw::vgx(), width, height, {.threads = threads}); };
    };
    add("reference/frame", frame.list, [] { return gw::make_reference(gw::vgx(), width, height); });
    add("fast/frame/1 thread", frame.list, fast(1));
    add("fast/frame/2 threads", frame.list, fast(2));
    add("fast/depth only/1 thread", frame.first_pass, fast(1));
    benchmark::RunSpecifiedBenchmarks();
}
