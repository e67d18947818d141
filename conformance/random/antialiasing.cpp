// Antialiased points, lines and polygons.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

float any_size(Random& r) {
    if (r.chance(30)) return 1;
    return float(r.chance(85) ? r.real(1, 6) : r.real(6, 128));
}

PolygonStippleState any_screen_door(Random& r) {
    std::array<std::uint32_t, 32> rows;
    for (std::uint32_t& row : rows) row = r.chance(50) ? 0xAAAAAAAA : r.bits(32);
    return {std::make_shared<const std::array<std::uint32_t, 32>>(rows)};
}

void any_primitive_state(Random& r, Script& s) {
    State& state = s.state;
    state.point_smooth = r.chance(70);
    state.line_smooth = r.chance(70);
    state.polygon_smooth = r.chance(75);
    state.point_size = any_size(r);
    state.line_width = any_size(r);
    state.polygon_mode = r.chance(70) ? PolygonMode::Fill : r.any(PolygonMode::Line);
    state.two_side_polygon_mode = r.chance(20);
    state.back_polygon_mode = r.any(PolygonMode::Fill);
    state.line_stipple = r.chance(40) ? any_dashes(r) : LineStippleState{};
    state.polygon_stipple = r.chance(15) ? any_screen_door(r) : PolygonStippleState{};
    state.polygon_offset =
        r.chance(30) ? any_polygon_offset(r, s.out.profile) : PolygonOffsetState{};
    state.polygon_offset.lines = s.out.profile.extensions.polygon_offset && r.chance(20);
    state.cull = r.chance(30) ? any_cull(r) : CullState{};
    state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
    state.scissor = r.chance(15) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
    state.clip_planes = {};
    if (r.chance(20)) any_clip_planes(r, s.frame, state);
}

BlendState over_or_any(Random& r) {
    if (r.chance(30)) return any_blend(r);
    return {.enable = true, .src = BlendFactor::SrcAlpha, .dst = BlendFactor::OneMinusSrcAlpha};
}

}  // namespace

// Antialiased points, lines and polygons of every size, with all that decides their values.
Case antialiasing_case(Random& r) {
    Profile profile = any_opengl_profile(r);
    profile.coverage_bits = r.chance(60) ? 8 : r.between(1, 16);
    Script s = script(r, profile);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        any_primitive_state(r, s);
        s.state.blend = over_or_any(r);
        s.state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
        s.state.depth = any_depth(r);
        s.state.stencil = r.chance(15) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.color_source = r.chance(10) ? ColorSource::PolygonId : ColorSource::Vertex;
        s.state.fog = r.chance(25) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        s.state.texture = any_texture_state(r);
        if (r.chance(10)) s.state.texture.gen = TexGen::EyeLinear;
        const MeshWish wish{.texcoords = true, .most = 6};
        const MeshRef mesh = r.chance(35)   ? any_lines(r, s.frame, wish)
                             : r.chance(35) ? any_points(r, s.frame, wish)
                                            : any_triangles(r, s.frame, wish);
        draw(s, mesh, 30);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
