// Scenes for the tests: the cases of scenes/hidden, and random ones. Does not draw.
#pragma once

#include "hiddensurface/run/compare.h"
#include "scene/draw/draw_commands.h"
#include "scene/draw/fit.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <random>

namespace gw::hiddensurface {

Algorithm mine();  ///< examples/hidden_surfaces/mine.cpp, the lecture's example

inline scene::Scene case_scene(const std::string& name) {
    scene::Scene scene =
        scene::read_scene(std::string(GW_SOURCE_DIR "/scenes/hidden/") + name + ".toml").scene;
    scene::add_defaults(scene, 160, 120);
    return scene;
}

/// A scene, its view and what the algorithms see of it.
struct Trial {
    explicit Trial(scene::Scene given, Profile with = vgx(), int width = 160, int height = 120)
        : scene(std::move(given)),
          view(scene::make_view(scene, width, height)),
          machine(make_fast(with, width, height, {.threads = 1})),
          input(make_input(scene, view, with)) {
        StepLog none;
        z_buffer = run_on(*machine, algorithm_named("z-buffer"), input, none);
    }
    Trial(const Trial&) = delete;

    /// Compared with the Z-buffer.
    Result run(const std::string& name) {
        StepLog none;
        return run(name, none);
    }
    Result run(const std::string& name, StepLog& log) {
        Result result = run_on(*machine, algorithm_named(name), input, log);
        compare(result, z_buffer.ids, input);
        return result;
    }

    scene::Scene scene;
    scene::View view;
    std::unique_ptr<Machine> machine;
    Input input;
    Result z_buffer;
};

/// Uniform in low .. high, the same numbers everywhere.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    float operator()(double low, double high) {
        return static_cast<float>(low + (high - low) * (double(engine_()) / 4294967295.0));
    }

private:
    std::mt19937 engine_;
};

inline scene::Scene polygon_scene(MeshData data) {
    scene::Scene scene;
    scene.materials.push_back({});
    scene.objects.push_back({.name = "polygons", .mesh = make_mesh(std::move(data))});
    scene.camera = scene::Camera{.eye = {0, 0, 6}, .at = {0, 0, 0}, .fov = 40};
    return scene;
}

/// Each component within its reach of 0; drawn in this order whatever the compiler, as arguments
/// are not.
inline vec3 random_vector(Random& random, double x, double y, double z) {
    const double c = random(-z, z), b = random(-y, y), a = random(-x, x);
    return {a, b, c};
}

/// `count` triangles in all directions that pass through each other.
inline scene::Scene random_triangles(std::uint32_t seed, int count) {
    Random random(seed);
    MeshData data;
    for (int i = 0; i < count; ++i) {
        const vec3 c = random_vector(random, 1.5, 1.2, 1.5);
        for (int k = 0; k < 3; ++k) data.positions.push_back(c + random_vector(random, 1, 1, 1));
    }
    return polygon_scene(std::move(data));
}

/// `count` rectangles facing the eye over the whole window, in random order of depth.
inline scene::Scene random_layers(std::uint32_t seed, int count) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i < count; ++i) {
        const float z = random(-4, 4);
        for (const auto& [x, y] :
             {std::pair(-9, -9), std::pair(9, -9), std::pair(9, 9), std::pair(-9, 9)})
            data.positions.push_back(vec3(float(x), float(y), z));
    }
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera->ortho_height = 8;
    return scene;
}

}  // namespace gw::hiddensurface
