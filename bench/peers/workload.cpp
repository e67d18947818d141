// The table of workloads.
#include "bench/peers/workload.h"

namespace gw::peers {
namespace {

constexpr DepthState first_pass{true, DepthFunc::Less, true};
constexpr BlendState replace{false, BlendFactor::One, BlendFactor::Zero};
constexpr int fill_quads = 100;

Pass z_pass() { return {.shade = Shade::None, .depth = first_pass, .blend = replace}; }

/// Z, then ambient, diffuse, specular for each light, then the reflection map; every colour
/// textured.
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

/// Each quad nearer than the last.
std::vector<Pass> quads(const Pass& pass) {
    std::vector<Pass> passes(fill_quads, pass);
    for (int i = 0; i < fill_quads; ++i)
        passes[std::size_t(i)].eye_from_quad[3].z = 0.8 - 0.016 * i;
    return passes;
}
/// The same with other texels for each quad: larger than the window, each at another position.
std::vector<Pass> moved_quads(const Pass& pass) {
    std::vector<Pass> passes = quads(pass);
    for (int i = 0; i < fill_quads; ++i) {
        dmat4& m = passes[std::size_t(i)].eye_from_quad;
        m[0].x = m[1].y = 1.3;
        m[3].x = 0.25 - 0.005 * i;
    }
    return passes;
}
/// The same, but no block's pixels have one depth.
std::vector<Pass> sloping_quads(const Pass& pass) {
    std::vector<Pass> passes = quads(pass);
    for (Pass& p : passes) p.eye_from_quad[0].z = 0.1;
    return passes;
}
/// The same, but no block's pixels have one colour.
std::vector<Pass> quads_over(const Pass& picture, const Pass& pass) {
    std::vector<Pass> passes = quads(pass);
    passes.insert(passes.begin(), picture);
    return passes;
}

std::vector<Workload> make_workloads() {
    const Pass id{.shade = Shade::Id, .depth = first_pass, .blend = replace};
    const Pass lit{.shade = Shade::Lit, .depth = first_pass, .blend = replace};
    Pass textured{
        .geometry = Geometry::Quad, .shade = Shade::VertexColor, .textured = true, .depth = {}};
    textured.blend = {true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha};
    const Pass flat{.geometry = Geometry::Quad, .shade = Shade::VertexColor, .depth = {}};
    const Pass z{
        .geometry = Geometry::Quad, .shade = Shade::None, .depth = first_pass, .blend = replace};
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
        {"l", "i, each quad elsewhere", 3, true, moved_quads(textured)},
        {"m", "j over a picture", 10, true, quads_over(textured, flat)},
        {"n", "k, sloping", 8, true, sloping_quads(z)},
    };
}

}  // namespace

std::span<const Workload> workloads() {
    static const std::vector<Workload> table = make_workloads();
    return table;
}

}  // namespace gw::peers
