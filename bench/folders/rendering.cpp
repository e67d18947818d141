// Rendering on the machine: multipass, itembuffer, raytrace, hiddensurface, radiosity.
#include "bench/folders/fig9.h"
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/interface/steps.h"
#include "itembuffer/render.h"
#include "radiosity/solver/solver.h"
#include "raytrace/tracer/render.h"
#include "raytrace/tracer/world.h"
#include "scene/toml/read_scene.h"

#include <benchmark/benchmark.h>

#include <limits>

namespace gw::bench {
namespace {

// Making a frame's commands: passes, shadow volumes.

void commands(benchmark::State& state) {
    const Ready scene = ready("fig9.toml");
    for (auto _ : state) benchmark::DoNotOptimize(frame(scene));
}
BENCHMARK(commands)->Name("multipass/commands of fig9")->Unit(benchmark::kMillisecond);

// Equation 5 [K4]: passes, item buffer, second rays.

void eq5(benchmark::State& state) {
    const Ready r = ready("fig9.toml");
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    multipass::Options passes;
    passes.pass_list = itembuffer::passes_with_tracing(r.scene, multipass::Translucency::Sorted);
    for (auto _ : state) {
        itembuffer::render(*machine, r.scene, r.view, passes, {.threads = 1});
        machine->reset_passes();
    }
}
BENCHMARK(eq5)->Name("itembuffer/frame with its hierarchy")->Unit(benchmark::kMillisecond);

// Building the hierarchy, and nearest hits of rays through the pixels.

void build(benchmark::State& state) {
    const Ready scene = ready("fig9.toml");
    for (auto _ : state) benchmark::DoNotOptimize(raytrace::World(scene.scene, 1));
}
BENCHMARK(build)->Name("raytrace/build")->Unit(benchmark::kMillisecond);

void nearest(benchmark::State& state) {
    const Ready scene = ready("fig9.toml");
    const raytrace::World world(scene.scene, 1);
    const dmat4 world_from_eye = glm::inverse(scene.view.eye_from_world);
    std::int64_t rays = 0;
    for (auto _ : state)
        for (int y = 0; y < height; y += 4)
            for (int x = 0; x < width; x += 4, ++rays) {
                const dvec3 eye((x + 0.5) / width - 0.5, (y + 0.5) / height - 0.5, -1);
                const raytrace::Ray ray{dvec3(world_from_eye[3]),
                                        transform3(dmat3(world_from_eye), eye)};
                benchmark::DoNotOptimize(
                    world.nearest(ray, std::numeric_limits<double>::infinity()));
            }
    state.SetItemsProcessed(rays);
}
BENCHMARK(nearest)->Name("raytrace/nearest")->Unit(benchmark::kMillisecond);

// Every hidden-surface algorithm [L] on one scene.

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

// One hemicube of the Cornell box [F2.2]: drawn, and with its form factors.

radiosity::PixmapModel cornell() {
    return radiosity::make_model(
        scene::read_scene(GW_SOURCE_DIR "/scenes/radiosity/cornell.toml").scene,
        {.texels_per_unit = 64 / 559.2});
}

void drawn(benchmark::State& state) {
    const radiosity::PixmapModel model = cornell();
    const int size = int(state.range(0));
    radiosity::HemicubePainter painter(size);
    radiosity::IdBuffers buffers;
    const radiosity::Hemicube cube =
        radiosity::hemicube_at({278, 540, 278}, {0, -1, 0}, 30, 0.1, 1000, size);
    for (auto _ : state) painter.draw(model, cube, buffers);
}
BENCHMARK(drawn)->Name("radiosity/hemicube")->Arg(128)->Arg(512)->Unit(benchmark::kMicrosecond);

void form_factors(benchmark::State& state) {
    const radiosity::PixmapModel model = cornell();
    radiosity::FormFactors factors(model, {.threads = 1});
    const std::vector<radiosity::ShootPoint> points{{{278, 540, 278}, {0, -1, 0}, 1, 10}};
    for (auto _ : state) benchmark::DoNotOptimize(factors.from_points(points, 0));
}
BENCHMARK(form_factors)->Name("radiosity/form factors of a point")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gw::bench
