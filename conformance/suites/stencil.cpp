// The stencil test with its operations and masks, followed by a depth test.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

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

}  // namespace gw::fuzz
