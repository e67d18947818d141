// The coordinates of a block's texels whose depths are compared with r. docs/manual/texture.md;
// scalar twin: gw/fast/shade/texture_by_pixel.cpp. Does not compare. Included once per Highway
// target.
#if defined(GW_FAST_COMPARED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COMPARED_INL_H_
#undef GW_FAST_COMPARED_INL_H_
#else
#define GW_FAST_COMPARED_INL_H_
#endif

#include "gw/base/powers.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/texels.h"
#include "gw/fast/raster/primitive.h"
#include "gw/fast/simd/planes-inl.h"
#include "gw/stages/perspective.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether a unit compares depths of a map with sides of powers of two, at coordinates that floats
/// hold: all scaling by powers of two is exact.
HWY_INLINE bool compares_block(const TextureState& s, const UnitOp& unit, const TexturePlanes& p) {
    const Texels& texels = unit.texels->texels;
    const auto fits = [](const TexturePlane& t) { return t.exponent <= largest_exponent_in_float; };
    return s.shadow_compare && !texels.with_r && !texels.any_size &&
           s.wrap_s != Wrap::MirroredRepeat && s.wrap_t != Wrap::MirroredRepeat &&
           (unit.projective || (fits(p.s) && fits(p.t)));
}

/// Compares the lanes of `mask`.
HWY_NOINLINE inline void compare_block(const TexturePlanes& p, const TexelValues& values,
                                       const TileDraw& draw, std::size_t unit, const UnitOp& op,
                                       std::uint32_t mask, ColorBlock& out) {
    const F32 f;
    const I32 d;
    const Texels& texels = op.texels->texels;
    const TextureState& state = texture_of(draw.op->state.state, unit);
    const int base = level_range(state, int(texels.levels.size())).base;
    const TexelLevel& level = texels.levels[std::size_t(base)];
    ComparedLanes lanes;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto q = hn::Load(d, values.q + i);
        if (op.projective) lanes.outside |= bits_of(d, hn::Lt(q, hn::Set(d, 1)), lanes32) << i;
        const auto w = hn::Div(hn::Set(f, 1.0f), hn::ConvertTo(f, q));
        const auto scaled = [&](const TexturePlane& t, const std::int32_t* u, int log2) {
            const auto scale = static_cast<float>(power_of_two(t.exponent + log2));
            return hn::Floor(
                hn::Mul(hn::Mul(hn::ConvertTo(f, hn::Load(d, u + i)), w), hn::Set(f, scale)));
        };
        const auto texel = [&](const TexturePlane& t, const std::int32_t* s, int log2_size) {
            const auto limit = hn::Set(f, 1073741824.0f);
            const auto u = hn::Max(hn::Neg(limit), hn::Min(scaled(t, s, log2_size + 8), limit));
            const auto k =
                hn::Set(d, static_cast<std::int32_t>(std::uint32_t(t.k) << (log2_size + 8)));
            return hn::ShiftRight<8>(hn::Add(hn::ConvertTo(d, u), k));
        };
        hn::Store(texel(p.s, values.s, level.log2_width), d, lanes.i + i);
        hn::Store(texel(p.t, values.t, level.log2_height), d, lanes.j + i);
        hn::Store(scaled(p.r, values.r, texels.depth_bits), f, lanes.r + i);
    }
    compare_depths(lanes, draw, unit, *op.texels, mask, out);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
