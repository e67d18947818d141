// Coverage: the pixels of a triangle and their depths and colours.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case raster_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.cull = any_cull(r);
        s.state.depth = {.test = r.chance(50)};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        // Additive, so that a pixel drawn twice is visible.
        s.state.blend = {.enable = r.chance(70), .src = BlendFactor::One, .dst = BlendFactor::One};
        draw(s, any_triangles(r, s.frame, {}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
