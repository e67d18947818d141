// Building the hierarchy, and nearest hits of rays through the pixels.
#include "bench/folders/fig9.h"
#include "raytrace/tracer/render.h"
#include "raytrace/tracer/world.h"

#include <benchmark/benchmark.h>

#include <limits>

namespace gw::bench {
namespace {

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

}  // namespace
}  // namespace gw::bench
