// Reading and writing files: scene, image, plot.
#include "image/plot/plot.h"
#include "image/write.h"
#include "scene/toml/read_scene.h"

#include <benchmark/benchmark.h>

#include <filesystem>

namespace gw::bench {
namespace {

// Reading a scene with its models.

void read(benchmark::State& state, const char* file) {
    for (auto _ : state) benchmark::DoNotOptimize(scene::read_scene(file));
}
BENCHMARK_CAPTURE(read, fig9, GW_SOURCE_DIR "/scenes/fig9.toml")
    ->Name("scene/read/fig9")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, cornell, GW_SOURCE_DIR "/scenes/cornell.toml")->Name("scene/read/cornell");

// A picture into a PNG file.

void write(benchmark::State& state) {
    std::vector<Rgba> color(640 * 480);
    for (std::size_t i = 0; i < color.size(); ++i)
        color[i] = {std::uint16_t(i % 251), std::uint16_t(i / 640 % 256),
                    std::uint16_t(i / 997 % 256), 255};
    const image::Picture picture = image::picture_of(color, 640, 480, 8);
    const auto file = std::filesystem::temp_directory_path() /
                      ("gw-bench-" + std::to_string(::getpid()) + ".png");
    for (auto _ : state) image::write_picture(file, picture);
    std::filesystem::remove(file);
}
BENCHMARK(write)->Name("image/write 640x480 png")->Unit(benchmark::kMillisecond);

// A plot of a thousand points.

void svg(benchmark::State& state) {
    plot::Plot plot{.title = "A parabola",
                    .command = "bench_folders",
                    .x = {.label = "x", .log = 0},
                    .y = {.label = "y", .log = 0}};
    plot::Series line{.name = "x^2", .points = {}};
    for (int i = 0; i < 1000; ++i) line.points.push_back({double(i), double(i) * i});
    plot.series.push_back(line);
    for (auto _ : state) benchmark::DoNotOptimize(plot::svg(plot));
}
BENCHMARK(svg)->Name("plot/svg")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gw::bench
