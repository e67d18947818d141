// The planes that commands read and write, and accumulation cleared to values.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

/// Values of -1 .. 1 and beyond, and ties.
Clear any_accum_clear(Random& r) {
    Clear c = any_clear(r);
    c.planes = PlaneMask(c.planes | mask_of(Plane::Accum));
    for (int i = 0; i < 4; ++i)
        c.accum[i] = float(r.chance(40)   ? r.pick({0.0, 1.0, -1.0, 0.5, -0.5})
                           : r.chance(80) ? r.real(-1, 1)
                                          : r.real(-3, 3));
    return c;
}

Profile any_profile_with_two_planes(Random& r) {
    Profile p = any_opengl_profile(r);
    p.color_planes = r.chance(90) ? 2 : 1;
    return p;
}

void any_buffers(Random& r, const Profile& p, State& s) {
    const bool two = p.color_planes == 2;
    s.draw_buffer =
        two ? r.any(DrawBuffer::FrontAndBack) : r.pick({DrawBuffer::Front, DrawBuffer::None});
    if (two) s.read_buffer = r.any(ReadBuffer::Back);
}

void any_buffers_step(Script& s) {
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 30) {
        Draw d = any_draw(s, any_triangles(r, s.frame, {.texcoords = true, .most = 5}));
        if (!s.color_slots.empty() && r.chance(40)) d.map = {{}, s.color_slots.back()};
        return add(s, std::move(d));
    }
    if (kind < 38) return add(s, any_accum_clear(r));
    if (kind < 60) return add(s, any_accumulate(r, s.out.profile));
    if (kind < 66) return add(s, any_read(r, s.out));
    if (kind < 71) return add(s, any_spans(r, s.out));
    if (kind < 78) return add(s, any_copy(r, s.out));
    if (kind < 82) return copy_texture(s, Plane::Color);
    if (kind < 86) return add(s, any_draw_pixels(s));
    if (kind < 93 && s.out.profile.color_planes == 2) return add(s, SwapBuffers{});
    add(s, any_pixels(r, s.out));
}

}  // namespace

// Both colour planes, drawn to and read in turn, exchanged; accumulation cleared to values.
Case buffers_case(Random& r) {
    Script s = script(r, any_profile_with_two_planes(r));
    const int steps = r.between(2, 16);
    for (int i = 0; i < steps; ++i) {
        if (r.chance(50)) any_buffers(r, s.out.profile, s.state);
        s.state.color_mask = r.chance(25) ? any_color_mask(r) : ColorMask{};
        s.state.scissor = r.chance(30) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        s.state.depth = r.chance(40) ? any_depth(r) : DepthState{};
        s.state.stencil = r.chance(30) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.blend = r.chance(40) ? any_extended_blend(r) : BlendState{};
        s.state.logic_op = r.chance(15) ? any_logic_op(r) : LogicOpState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        any_buffers_step(s);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
