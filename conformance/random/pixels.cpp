// Commands on pixels, and the accumulation buffer.
#include "conformance/generate/pixels.h"
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// Commands on pixels, in any order, under any state.

namespace {

void any_command(Script& s) {
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 15) return add(s, any_clear(r));
    if (kind < 35) return add(s, any_spans(r, s.out));
    if (kind < 55) return add(s, any_pixels(r, s.out));
    if (kind < 70) return add(s, any_copy(r, s.out));
    if (kind < 80) return add(s, any_read(r, s.out));
    if (kind < 88) return copy_texture(s, r.pick({Plane::Color, Plane::Depth}));
    if (kind < 92) return add(s, any_accumulate(r, s.out.profile));
    draw(s, any_mesh(r, s.frame, {.texcoords = true, .most = 5}), 50);
}

}  // namespace

Case pixels_case(Random& r) {
    Script s = script(r);
    const int steps = r.between(2, 14);
    for (int i = 0; i < steps; ++i) {
        s.state.scissor = r.chance(30) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        s.state.alpha = r.chance(25) ? any_alpha(r) : AlphaState{};
        s.state.stencil = r.chance(40) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.depth = r.chance(60) ? any_depth(r) : DepthState{};
        s.state.blend = r.chance(40) ? any_blend(r) : BlendState{};
        s.state.color_mask = any_color_mask(r);
        any_command(s);
        between_draws(s);
    }
    return s.out;
}

// The accumulation buffer: every operation, weights that give ties, overflow and return.
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

}  // namespace gw::conformance
