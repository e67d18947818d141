// Multi-sampling by accumulation: the same draws with other jitters [K4a].
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case jitter_case(Random& r) {
    Script s = script(r);
    const auto mesh = any_mesh(r, s.frame, {}), other = any_mesh(r, s.frame, {});
    const int frames = r.between(1, 5);
    for (int i = 0; i < frames; ++i) {
        s.state.jitter = any_jitter(r, s.out.profile);
        s.state.depth.test = true;
        add(s, Clear{mask_of(Plane::Color) | mask_of(Plane::Depth), any_color(r)});
        draw(s, mesh);
        if (r.chance(50)) s.state.jitter = any_jitter(r, s.out.profile);
        draw(s, other);
        add(s, Accumulate{i == 0 && r.chance(50) ? AccumOp::Load : AccumOp::Accum, 1});
        between_draws(s);
    }
    if (r.chance(70)) add(s, Accumulate{AccumOp::Return, 1.0f / float(frames)});
    return s.out;
}

}  // namespace gw::fuzz
