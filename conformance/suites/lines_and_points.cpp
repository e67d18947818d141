// Lines and points: wide, steep, clipped, on grid points, textured and fogged.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case lines_and_points_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        const auto width = [&r] {
            return r.chance(50) ? 1 : r.chance(80) ? r.between(2, 9) : r.between(10, 128);
        };
        s.state.line_width = width();
        s.state.point_size = width();
        s.state.depth = any_depth(r);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
        s.state.scissor = r.chance(20) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        s.state.clip_planes = {};
        if (r.chance(20)) any_clip_planes(r, s.frame, s.state);
        s.state.fog = r.chance(15) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        s.state.texture = any_texture_state(r);
        const MeshWish wish{.texcoords = true, .most = 8};
        draw(s, r.chance(65) ? any_lines(r, s.frame, wish) : any_points(r, s.frame, wish), 20);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
