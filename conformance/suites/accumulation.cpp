// The accumulation buffer: every operation, weights that give ties, overflow and return.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case accumulation_case(Random& r) {
    Script s = script(r);
    const int steps = r.between(2, 14);
    for (int i = 0; i < steps; ++i) {
        s.state.color_mask = any_color_mask(r);
        s.state.scissor = r.chance(40) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        if (r.chance(30)) draw(s, any_triangles(r, s.frame, {.most = 5}));
        if (r.chance(15)) add(s, any_pixels(r, s.out));
        const int repeats = r.chance(5) ? r.between(100, 140) : r.between(1, 3);
        const Accumulate a = any_accumulate(r, s.out.profile);
        for (int k = 0; k < repeats && s.out.width * s.out.height * repeats < 100000; ++k)
            add(s, a);
        if (r.chance(5)) add(s, any_clear(r));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
