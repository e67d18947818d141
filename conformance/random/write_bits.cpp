// Some bits of a channel are written, by every command that writes colours.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "gw/base/arithmetic.h"

namespace gw::conformance {
namespace {

/// None, all, those of an index's part, or any. Bits above those of the profile have no effect.
std::uint16_t any_bits(Random& r, const Profile& p) {
    const int kind = r.below(100);
    if (kind < 15) return 0;
    if (kind < 30) return 0xFFFF;
    if (kind < 40) return std::uint16_t(max_of_bits(p.color_bits));
    if (kind < 60) return r.pick<std::uint16_t>({0x0F, 0xF0, 0x80, 0xFF, 0x3F});
    return std::uint16_t(r.bits(16));
}

ColorMaskBits any_mask_bits(Random& r, const Profile& p) {
    if (r.chance(10)) return {};
    return {any_bits(r, p), any_bits(r, p), any_bits(r, p), any_bits(r, p)};
}

void any_write_bits_step(Script& s) {
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 15) return add(s, any_clear(r));
    if (kind < 22) return add(s, any_spans(r, s.out));
    if (kind < 34) return add(s, any_pixels(r, s.out));
    if (kind < 42) return add(s, any_copy(r, s.out));
    if (kind < 52) return add(s, any_accumulate(r, s.out.profile));
    if (kind < 58 && s.out.profile.extensions.draw_pixels) return add(s, any_draw_pixels(s));
    const MeshWish wish{.texcoords = true, .most = 5};
    draw(
        s,
        r.chance(25) ? cover_mesh(r, s.frame, wish, any_z(r, s.frame)) : any_mesh(r, s.frame, wish),
        40);
}

void any_joining(Random& r, const Profile& p, State& s) {
    const bool has_all = p.extensions.blend_minmax;
    s.blend = r.chance(60) ? BlendState{} : has_all ? any_extended_blend(r) : any_blend(r);
    s.logic_op = p.extensions.logic_op && r.chance(20) ? any_logic_op(r) : LogicOpState{};
    if (p.color_planes == 2) s.draw_buffer = r.any(DrawBuffer::FrontAndBack);
}

}  // namespace

Case write_bits_case(Random& r) {
    Script s = script(r, r.chance(50) ? any_profile(r) : any_opengl_profile(r));
    if (r.chance(90)) add(s, any_pixels(r, s.out));
    const int steps = r.between(2, 9);
    for (int i = 0; i < steps; ++i) {
        State& state = s.state;
        state.color_mask_bits = any_mask_bits(r, s.out.profile);
        state.color_mask = r.chance(20) ? any_color_mask(r) : ColorMask{};
        any_joining(r, s.out.profile, state);
        state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
        state.depth = r.chance(40) ? any_depth(r) : DepthState{};
        state.scissor = r.chance(20) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        state.shade_model = r.any(ShadeModel::Smooth);
        state.texture = any_texture_state(r);
        any_write_bits_step(s);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
