// Lines and outlines by OpenGL's diamond rule.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

Case diamond_lines_case(Random& r) {
    Script s = script(r, any_opengl_profile(r));
    const Extensions& has = s.out.profile.extensions;
    const int draws = r.between(2, 6);
    for (int i = 0; i < draws; ++i) {
        State& state = s.state;
        state.diamond_lines = r.chance(85);
        state.line_width = float(r.chance(50)   ? 1
                                 : r.chance(80) ? r.between(2, 9)
                                                : r.between(10, 128));
        state.line_smooth = s.out.profile.coverage_bits > 0 && r.chance(10);
        state.line_stipple = has.stipple && r.chance(40) ? any_dashes(r) : LineStippleState{};
        state.polygon_mode = PolygonMode::Line;
        state.cull = r.chance(30) ? any_cull(r) : CullState{};
        state.depth = any_depth(r);
        state.shade_model = r.any(ShadeModel::Smooth);
        state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
        state.scissor = r.chance(20) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        state.clip_planes = {};
        if (r.chance(15)) any_clip_planes(r, s.frame, state);
        state.fog = r.chance(15) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        state.texture = any_texture_state(r);
        const MeshWish wish{.texcoords = true, .most = 8};
        const MeshRef mesh =
            r.chance(75) ? any_lines(r, s.frame, wish) : any_triangles(r, s.frame, wish);
        draw(s, mesh, 30);
        if (r.chance(25)) {  // the same fragments again
            state.depth = {.test = true, .func = DepthFunc::Equal, .mask = false};
            draw(s, mesh, 30);
        }
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
