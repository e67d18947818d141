// One hemicube of the Cornell box [F2.2]: drawn, and with its form factors.
#include "radiosity/solver/solver.h"
#include "scene/read_scene.h"

#include <benchmark/benchmark.h>

namespace gw::bench {
namespace {

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
