// Tests of fragments, and blending.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// The stencil test with its operations and masks, followed by a depth test.
Case stencil_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(2, 9);
    for (int i = 0; i < draws; ++i) {
        s.state.stencil = any_stencil(r, s.out.profile);
        s.state.depth = any_depth(r);
        s.state.alpha = r.chance(15) ? any_alpha(r) : AlphaState{};
        s.state.cull = r.chance(20) ? any_cull(r) : CullState{};
        const double z = any_z(r, s.frame);
        draw(s, r.chance(30) ? cover_mesh(r, s.frame, {}, z) : any_mesh(r, s.frame, {.most = 8}));
        if (r.chance(10)) add(s, any_clear(r));
        between_draws(s);
    }
    return s.out;
}

// The depth test and its plane.
Case depth_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(2, 8);
    for (int i = 0; i < draws; ++i) {
        s.state.depth = any_depth(r);
        if (r.chance(30)) s.state.depth_range = any_depth_range(r);
        s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
        s.state.color_mask = r.chance(80) ? ColorMask{} : any_color_mask(r);
        const double z = any_z(r, s.frame);
        draw(s,
             r.chance(25) ? cover_mesh(r, s.frame, {}, z) : any_triangles(r, s.frame, {.most = 8}));
        between_draws(s);
    }
    return s.out;
}

// The alpha test while few or no channels are written: alpha decides depths, stencil values and
// counters, although no colour shows it.
Case alpha_mask_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.alpha = any_alpha(r);
        s.state.alpha.test = true;
        s.state.color_mask =
            r.chance(60) ? ColorMask{false, false, false, false} : any_color_mask(r);
        s.state.depth = any_depth(r);
        s.state.stencil = r.chance(50) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.color_source = r.any(ColorSource::PolygonId);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.fog = r.chance(20) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        if (r.chance(30)) s.state.texture = any_texture_state(r);
        const MeshWish wish{.normals = true, .texcoords = true, .most = 6};
        draw(s, any_mesh(r, s.frame, wish), 40);
        between_draws(s);
    }
    return s.out;
}

// Blending, colour masks and the alpha test over a random background.
Case blend_case(Random& r) {
    Script s = script(r);
    add(s, any_pixels(r, s.out));
    const int draws = r.between(1, 7);
    for (int i = 0; i < draws; ++i) {
        s.state.blend = any_blend(r);
        s.state.color_mask = any_color_mask(r);
        s.state.alpha = r.chance(40) ? any_alpha(r) : AlphaState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        if (r.chance(25))
            add(s, any_pixels(r, s.out));
        else if (r.chance(10))
            add(s, any_spans(r, s.out));
        else
            draw(s, any_triangles(r, s.frame, {.most = 6}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
