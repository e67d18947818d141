#include "bench/growth/sweep.h"
#include "bench/peers/frame.h"
#include "bench/peers/ours.h"
#include "bench/peers/workload.h"
#include "gw/machine.h"
#include "gw/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace gw::growth {
namespace {

struct Subdivider {
    MeshData data;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles{};

    template <typename T>
    static void add_middle(std::vector<T>& values, std::uint32_t a, std::uint32_t b) {
        if (!values.empty()) values.push_back((values[a] + values[b]) * 0.5f);
    }
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                      std::uint32_t(data.positions.size()));
        if (is_new) {
            add_middle(data.positions, a, b), add_middle(data.normals, a, b);
            add_middle(data.texcoords, a, b), add_middle(data.colors, a, b);
        }
        return at->second;
    }
    void cut(const std::array<std::uint32_t, 3>& v) {
        const std::uint32_t ab = middle(v[0], v[1]), bc = middle(v[1], v[2]),
                            ca = middle(v[2], v[0]);
        for (const std::uint32_t i : {v[0], ab, ca, ab, v[1], bc, ca, bc, v[2], ab, bc, ca})
            data.indices.push_back(i);
    }
};

/// Every triangle cut in four at its sides' middles, which neighbours share. Positions, normals and
/// texture coordinates are averaged; polygons become their triangles.
MeshRef subdivided(const Mesh& mesh) {
    Subdivider s{{.primitive = Primitive::Triangles,
                  .positions = mesh.data().positions,
                  .normals = mesh.data().normals,
                  .texcoords = mesh.data().texcoords,
                  .colors = mesh.data().colors}};
    for (const Triangle& t : mesh.triangles()) s.cut(t.vertex);
    return make_mesh(std::move(s.data));
}

using peers::Frame;
using peers::Pass;
using peers::Shade;
using peers::Workload;

constexpr int many_lights = 128;

/// Each part's mesh cut in four `times` times.
Frame divided_frame(const std::string& scene, int width, int height, int times) {
    Frame f = peers::scene_frame(scene.c_str(), width, height);
    for (peers::Part& part : f.scene)
        for (int i = 0; i < times; ++i) part.mesh = subdivided(*part.mesh);
    return f;
}

/// The usual frame with lamps all around.
Frame lit_frame(const std::string& scene) {
    Frame f = peers::scene_frame(scene.c_str());
    Light light = f.lights[0];
    f.lights.clear();
    for (int i = 0; i < many_lights; ++i) {
        light.position = vec4(float(i % 16) * 0.5f - 4, 3 + float(i / 64), -2 - float(i / 16), 1);
        f.lights.push_back(light);
    }
    return f;
}

/// Z, and as many textured passes under Equal.
Workload passes(int count, int lights = 1) {
    Workload w{"passes", "Z and passes", 0, false, {}};
    w.passes.push_back({.shade = Shade::None,
                        .depth = {true, DepthFunc::Less, true},
                        .blend = {false, BlendFactor::One, BlendFactor::Zero}});
    const Shade shades[] = {Shade::Ambient, Shade::Diffuse, Shade::Specular};
    for (int i = 0; i < count; ++i)
        w.passes.push_back({.shade = shades[i % 3], .textured = true, .light = i / 3 % lights});
    return w;
}

Workload samples(int count) {
    Workload w = passes(3);
    w.samples.clear();
    for (int i = 0; i < count; ++i) w.samples.push_back({i % 8, i / 8 % 8});
    return w;
}

/// Every run has another view, so it cannot reuse kept data of the last one.
Step step(double amount, const std::function<Frame()>& frame, const Workload& workload,
          int threads = 1) {
    return {amount, [=](int repeats) {
                const Frame f = frame();
                const auto machine = make_fast(vgx(), f.width, f.height, {.threads = threads});
                CommandList list = peers::command_list(workload, f);
                return least_time(repeats, [&] {
                    list = peers::moved(std::move(list));
                    machine->execute(list);
                    machine->reset_passes();
                });
            }};
}

}  // namespace

std::vector<Sweep> machine_sweeps(const std::string& scene) {
    const auto usual = [scene] { return peers::scene_frame(scene.c_str()); };
    Sweep triangles{"triangles", "triangles", {}}, pixels{"pixels", "pixels", {}},
        pass{"passes", "passes", {}}, sample{"samples", "samples", {}},
        light{"lights", "lights", {}}, threads{"threads", "threads", {}};
    for (int times = 0; times <= 3; ++times)
        triangles.steps.push_back(step(
            77628 * std::pow(4.0, times), [=] { return divided_frame(scene, 640, 480, times); },
            passes(3)));
    for (const auto& [width, height] :
         {std::pair{320, 240}, {640, 480}, {1280, 960}, {2560, 1920}, {4096, 4096}})
        pixels.steps.push_back(step(
            double(width) * height,
            [=, w = width, h = height] { return divided_frame(scene, w, h, 0); }, passes(3)));
    for (int n = 1; n <= 128; n *= 2) pass.steps.push_back(step(n, usual, passes(n)));
    for (int n = 1; n <= 256; n *= 4) sample.steps.push_back(step(n, usual, samples(n)));
    for (int n = 1; n <= many_lights; n *= 2)
        light.steps.push_back(step(
            n, [=] { return lit_frame(scene); }, passes(3 * n, n)));
    for (int n = 1; n <= 2; ++n) threads.steps.push_back(step(n, usual, passes(12), n));
    return {triangles, pixels, pass, sample, light, threads};
}

Step largest_frame(const std::string& scene) {
    return step(
        77628 * 64.0, [=] { return divided_frame(scene, 4096, 4096, 3); }, passes(64), 2);
}

}  // namespace gw::growth
