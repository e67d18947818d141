// What the machine has for OpenGL 1.2 to 1.5.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// Colours and alpha blended by factors and equations of their own.
Case separate_blend_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::blend_square));
    add(s, any_pixels(r, s.out));
    const int draws = r.between(1, 7);
    for (int i = 0; i < draws; ++i) {
        s.state.blend = any_separate_blend(r);
        s.state.logic_op = r.chance(10) ? any_logic_op(r) : LogicOpState{};
        s.state.color_mask = any_color_mask(r);
        s.state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        if (r.chance(25))
            add(s, any_pixels(r, s.out));
        else
            draw(s, any_triangles(r, s.frame, {.most = 6}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
