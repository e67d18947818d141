// Fog from given coordinates, a vector of doubles at a time. docs/manual/fog.md; scalar twins:
// direct_fog_factor() of gw/stages/fog.h, given_fog.cpp. Does not blend it. Included once per Highway
// target.
#if defined(GW_FAST_GIVEN_FOG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_GIVEN_FOG_INL_H_
#undef GW_FAST_GIVEN_FOG_INL_H_
#else
#define GW_FAST_GIVEN_FOG_INL_H_
#endif

#include "gw/base/powers.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/fast/raster/primitive.h"
#include "gw/fast/simd/planes-inl.h"
#include "gw/fast/vertices/power-inl.h"
#include "gw/stages/fog.h"

#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

/// e^x as a fraction of 1: 1 from x = 0 on.
HWY_INLINE V64 exp_up_to_one(V64 x) {
    const auto in_range = hn::Min(hn::Max(x, all(-746)), all(0));
    return exp_of_sum({in_range, hn::Zero(D64())});
}
/// fog_factor() before it is rounded; z is no NaN.
HWY_INLINE V64 fog_of(const FogState& fog, V64 z) {
    const auto depth = hn::Mul(all(double(fog.density)), z);
    switch (fog.mode) {
        case FogMode::Linear: break;
        case FogMode::Exp: return exp_up_to_one(hn::Neg(depth));
        case FogMode::Exp2: return exp_up_to_one(hn::Neg(hn::Mul(depth, depth)));
    }
    return hn::Div(hn::Sub(all(double(fog.end)), z), all(double(fog.end) - double(fog.start)));
}

/// The fog factors of the lanes of `mask` in block (bx, by). Others may get arbitrary ones.
HWY_NOINLINE inline void find_given_fog_lanes(const GivenFog& fog, const TileDraw& draw, int bx,
                                              int by, std::uint32_t mask, std::uint32_t* factor) {
    const FogState& state = draw.op->state.state.fog;
    const int bits = draw.op->state.bits;
    const double unit = fog_unit(state, bits);
    if (!std::isfinite(unit) || std::popcount(mask) == 1)
        return find_given_fog(fog, draw, bx, by, mask, factor);
    const D64 d;
    const I32ForD64 i32;
    alignas(64) float coordinate[block_pixels];
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        hn::Store(hn::Mul(to_floats(wide_plane(fog.numerator, at)), reciprocal_lanes(fog.q, at)),
                  F32(), coordinate + i);
    }
    const hn::Rebind<float, D64> f;
    const hn::Rebind<std::uint32_t, D64> u32;
    const auto scale = all(power_of_two(fog.exponent));
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
        const auto u = hn::PromoteTo(d, hn::Load(f, coordinate + i));
        const auto z = hn::Mul(all(unit), hn::Add(all(fog.offset), hn::Mul(u, scale)));
        const auto rounded = hn::DemoteTo(i32, quantized(fog_of(state, z), bits));
        hn::Store(hn::BitCast(u32, rounded), u32, factor + i);
    }
}

#else

HWY_INLINE void find_given_fog_lanes(const GivenFog& fog, const TileDraw& draw, int bx, int by,
                                     std::uint32_t mask, std::uint32_t* factor) {
    find_given_fog(fog, draw, bx, by, mask, factor);
}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
