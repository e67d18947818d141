// Coverage: which pixels a triangle has, and the depth and colour there.
#include "tests/fuzz/generate_draw.h"
#include "tests/fuzz/generate_state.h"
#include "tests/fuzz/suites.h"

namespace gw::fuzz {

Case raster_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.cull = any_cull(r);
        s.state.depth = {.test = r.chance(50)};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        // Additive: what is drawn twice shows.
        s.state.blend = {.enable = r.chance(70), .src = BlendFactor::One, .dst = BlendFactor::One};
        draw(s, any_triangles(r, s.frame, {}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
