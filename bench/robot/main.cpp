// Pictures of a robot simulator, one after the other, on the OSMesa that the loader finds:
// bench_robot. The bodies move from one to the next; each picture is read. Prints the least and the
// median of their milliseconds of processor time, and the renderer.
#include "tests/gl/programs/robot/scene.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <ctime>
#include <vector>

namespace robot {
namespace {

double milliseconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

void run(Scene& scene, int pictures) {
    constexpr int untimed = 2;
    open_scene(scene, "osmesa");
    std::vector<double> times;
    for (int i = -untimed; i < pictures; ++i) {
        scene.moved = 0.01f * float(i);
        const double start = milliseconds();
        draw_picture(scene);
        read_colors(scene);
        if (i >= 0) times.push_back(milliseconds() - start);
    }
    std::ranges::sort(times);
    fmt::print("{:.3f} {:.3f} {}\n", times.front(), times[times.size() / 2],
               reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)));
}

}  // namespace
}  // namespace robot

int main(int argc, char** argv) {
    robot::Scene scene;
    robot::Options& o = scene.options;
    o.width = o.height = 256;
    int pictures = 10;
    CLI::App app{
        "Pictures of a robot simulator on the OSMesa of LD_LIBRARY_PATH.\nExample: bench_robot --samples 0"};
    app.add_option("--shadow", o.shadow, "pixels of a shadow map's side")->capture_default_str();
    app.add_option("--width", o.width, "of a picture")->capture_default_str();
    app.add_option("--height", o.height, "of a picture")->capture_default_str();
    app.add_option("--samples", o.samples, "of a pixel: 0 or 4")->capture_default_str();
    app.add_option("--pictures", pictures, "timed ones")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    robot::run(scene, pictures);
}
