// A picture into a PNG file.
#include "image/write.h"

#include <benchmark/benchmark.h>

#include <filesystem>

namespace gw::bench {
namespace {

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

}  // namespace
}  // namespace gw::bench
