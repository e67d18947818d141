// Blending, colour masks and the alpha test over a random background.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

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

}  // namespace gw::fuzz
