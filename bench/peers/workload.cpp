// The table of workloads.
#include "bench/peers/workload.h"

namespace gw::peers {
namespace {

constexpr DepthState first_pass{true, DepthFunc::Less, true};
constexpr BlendState replace{false, BlendFactor::One, BlendFactor::Zero};
constexpr int fill_quads = 100;

Pass z_pass() { return {.shade = Shade::None, .depth = first_pass, .blend = replace}; }

/// Z, then ambient, diffuse, specular for each light, then the reflection map; every colour textured.
std::vector<Pass> multi_pass(int lights, Stencil stencil = Stencil::Off, Fog fog = Fog::Off) {
    std::vector<Pass> passes{z_pass()};
    if (stencil != Stencil::Off)
        for (const Stencil side : {Stencil::Increment, Stencil::Decrement})
            passes.push_back({.geometry = Geometry::Volumes,
                              .shade = Shade::None,
                              .depth = {true, DepthFunc::Less, false},
                              .blend = replace,
                              .stencil = side});
    if (fog != Fog::Off) passes.push_back({.shade = Shade::Black, .fog = Fog::Colored});
    for (int light = 0; light < lights; ++light) {
        passes.push_back({.shade = Shade::Ambient, .textured = true, .light = light, .fog = fog});
        for (const Shade shade : {Shade::Diffuse, Shade::Specular})
            passes.push_back(
                {.shade = shade, .textured = true, .light = light, .stencil = stencil, .fog = fog});
    }
    passes.push_back({.shade = Shade::Reflection, .textured = true, .fog = fog});
    return passes;
}

std::vector<Pass> quads(const Pass& pass) {
    std::vector<Pass> passes(fill_quads, pass);
    for (int i = 0; i < fill_quads; ++i) passes[std::size_t(i)].depth_at = 0.9 - 0.008 * i;
    return passes;
}

std::vector<Workload> make_workloads() {
    const Pass id{.shade = Shade::Id, .depth = first_pass, .blend = replace};
    const Pass lit{.shade = Shade::Lit, .depth = first_pass, .blend = replace};
    Pass textured{.geometry = Geometry::Quad, .shade = Shade::VertexColor, .textured = true, .depth = {}};
    textured.blend = {true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha};
    const Pass flat{.geometry = Geometry::Quad, .shade = Shade::VertexColor, .depth = {}};
    const Pass z{.geometry = Geometry::Quad, .shade = Shade::None, .depth = first_pass, .blend = replace};
    return {
        {"a", "depth only", 4, false, {z_pass()}},
        {"b", "item buffer: flat 24-bit ids", 4, false, {id}},
        {"c", "one lit Gouraud pass, 1 light", 4, false, {lit}},
        {"d", "multi-pass, 1 light", 8, false, multi_pass(1)},
        {"e", "multi-pass, 4 lights", 10, false, multi_pass(4)},
        {"f", "d with stencil shadow volumes", 8, false, multi_pass(1, Stencil::OutsideShadow)},
        {"g",
         "d with 8 jittered samples",
         10,
         false,
         multi_pass(1),
         {{1, 4}, {3, 1}, {4, 6}, {6, 3}, {0, 7}, {7, 0}, {2, 2}, {5, 5}}},
        {"h", "two-step fog", 8, false, multi_pass(1, Stencil::Off, Fog::Black)},
        {"i", "fill: textured bilinear, blended", 3, true, quads(textured)},
        {"j", "fill: flat, blended One, One", 10, true, quads(flat)},
        {"k", "fill: Z only", 8, true, quads(z)},
    };
}

}  // namespace

std::span<const Workload> workloads() {
    static const std::vector<Workload> table = make_workloads();
    return table;
}

}  // namespace gw::peers
