// Fog in every mode, at the vertex and per fragment.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case fog_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.fog = any_fog(r, eye_depth(s.frame));
        s.state.depth.test = r.chance(50);
        s.state.blend =
            r.chance(40) ? BlendState{true, BlendFactor::One, BlendFactor::One} : BlendState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.texture = any_texture_state(r);
        draw(s, any_mesh(r, s.frame, {.texcoords = true, .most = 7}), 20);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
