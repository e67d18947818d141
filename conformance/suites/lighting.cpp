// Lighting at the vertices.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case lighting_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.color_source = ColorSource::Lighting;
        s.state.lighting = any_lighting(r);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.cull = r.chance(30) ? any_cull(r) : CullState{};
        s.state.depth.test = r.chance(60);
        s.state.blend =
            r.chance(40) ? BlendState{true, BlendFactor::One, BlendFactor::One} : BlendState{};
        s.state.fog = r.chance(20) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        draw(s, any_mesh(r, s.frame, {.normals = r.chance(95), .colors = r.chance(20)}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
