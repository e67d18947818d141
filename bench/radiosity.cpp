// Shots per second against hemicube resolution, texels and polygons: bench_radiosity. The ratios of one run
// are the figures in docs/radiosity.md. Does not compare results.
#include "radiosity/solver.h"

#include "scene/read_scene.h"

#include <benchmark/benchmark.h>

namespace {

using namespace gw;

/// The scene of the sphere in a box, with a bumpy sheet of 2 segments^2 triangles in place of the sphere.
scene::Scene box_with(int segments) {
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/radiosity/sphere.toml").scene;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int j = 0; j <= segments; ++j)
        for (int i = 0; i <= segments; ++i)
            positions.push_back({float(2 * i) / float(segments) - 1,
                                 0.1f + 0.05f * float((i * 7 + j * 5) % 4) / float(segments),
                                 float(2 * j) / float(segments) - 1});
    const auto at = [&](int i, int j) { return std::uint32_t(j * (segments + 1) + i); };
    for (int j = 0; j < segments; ++j)
        for (int i = 0; i < segments; ++i)
            indices.insert(indices.end(), {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1),
                                           at(i + 1, j + 1)});
    scene.objects[1].mesh = make_mesh({.positions = positions, .indices = indices});
    scene.objects[1].world_from_object = dmat4(1);
    return scene;
}

void hemicubes(benchmark::State& state, int size, double texels, int segments) {
    const radiosity::Model model = radiosity::make_model(box_with(segments), {.texels_per_unit = texels});
    radiosity::FormFactors factors(model, {.hemicube = size, .threads = 1});
    const std::vector<radiosity::ShootPoint> points(8, {{0, 1.9, 0}, {0, -1, 0}, 0.125, 0.1});
    for (auto _ : state) benchmark::DoNotOptimize(factors.from_points(points, 0));
    state.SetItemsProcessed(state.iterations() * 8);
    state.counters["texels"] = double(model.texel_count());
    state.counters["facets"] = double(model.facets.size());
}

void add(const std::string& name, int size, double texels, int segments) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        hemicubes(state, size, texels, segments);
    })->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    for (int size : {32, 64, 128, 256, 512}) add("hemicube/" + std::to_string(size), size, 12, 4);
    for (int texels : {4, 8, 16, 32, 64}) add("texels/" + std::to_string(texels), 128, texels, 4);
    for (int segments : {4, 16, 64, 128})
        add("polygons/" + std::to_string(2 * segments * segments), 128, 12, segments);
    benchmark::RunSpecifiedBenchmarks();
}
