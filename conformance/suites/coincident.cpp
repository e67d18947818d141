// Many faces of one depth: a prepass, then the same faces by other primitives under Equal.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {
namespace {

void any_second_pass(Script& s) {
    Random& r = s.random;
    s.state.depth = {true, r.chance(75) ? DepthFunc::Equal : DepthFunc::LEqual, r.chance(20)};
    s.state.blend = {.enable = r.chance(85), .src = BlendFactor::One, .dst = BlendFactor::One};
    s.state.alpha = r.chance(10) ? any_alpha(r) : AlphaState{};
    s.state.stencil = r.chance(25) ? any_stencil(r, s.out.profile) : StencilState{};
    s.state.shade_model = r.any(ShadeModel::Smooth);
    if (r.chance(10)) s.state.jitter = any_jitter(r, s.out.profile);
    if (r.chance(10)) s.state.scissor = any_scissor(r, s.out.width, s.out.height);
    if (r.chance(10)) s.state.cull = any_cull(r);
    if (r.chance(5)) s.state.polygon_mode = r.any(PolygonMode::Fill);
    if (r.chance(5)) s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
}

}  // namespace

Case coincident_case(Random& r) {
    Script s = script(r);
    std::vector<MeshRef> meshes;
    const int count = r.between(1, 3);
    s.state.depth.test = true;
    s.state.color_mask = {r.chance(50), r.chance(50), true, true};
    for (int i = 0; i < count; ++i) {
        meshes.push_back(any_mesh(r, s.frame, {.most = 6}));
        if (i > 0 && r.chance(40)) meshes.back() = same_faces(r, *meshes[0]);
        draw(s, meshes.back());
    }
    s.state.color_mask = {};
    const int passes = r.between(1, 5);
    for (int i = 0; i < passes; ++i) {
        any_second_pass(s);
        for (const MeshRef& mesh : meshes)
            if (r.chance(80)) draw(s, r.chance(70) ? mesh : same_faces(r, *mesh));
        if (r.chance(10)) add(s, any_clear(r));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
