// The bounds of fragments: viewport, scissor, window, depth range.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case viewport_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.viewport = any_viewport(r, s.out.width, s.out.height);
        s.state.scissor = any_scissor(r, s.out.width, s.out.height);
        s.state.depth_range = any_depth_range(r);
        s.state.depth = any_depth(r);
        draw(s, any_mesh(r, s.frame, {}));
        if (r.chance(20)) add(s, any_clear(r));
        if (r.chance(10)) add(s, any_accumulate(r, s.out.profile));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
