// Positions of lanes on a level of any size, folded by a wrap, and the indices of their texels.
// docs/manual/texture.md; scalar twins: any_position() of gw/stages/perspective.h, gw/stages/texels.h.
// Does not fetch. Included once per Highway target.
#if defined(GW_FAST_POSITIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_POSITIONS_INL_H_
#undef GW_FAST_POSITIONS_INL_H_
#else
#define GW_FAST_POSITIONS_INL_H_
#endif

#include "gw/fast/simd/doubles-inl.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/stages/texels.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

/// Of whole numbers below 2^50. 0 may be the period: the quotient of a multiple of it may be too
/// small by one.
HWY_INLINE V64 modulo_of(V64 n, V64 period) {
    const auto quotient = hn::Floor(hn::Mul(n, hn::Div(hn::Set(D64(), 1.0), period)));
    return hn::Sub(n, hn::Mul(quotient, period));
}
/// The whole position n, below 2^50, on a level of `texels` 256ths of a texel. Under a repetition 0
/// may be the period.
HWY_INLINE V64 folded_position(V64 n, V64 texels, Wrap wrap) {
    const D64 d;
    if (wrap == Wrap::Repeat) return modulo_of(n, texels);
    if (wrap == Wrap::MirroredRepeat) return modulo_of(n, hn::Add(texels, texels));
    return hn::Max(hn::Set(d, -0x1p30), hn::Min(n, hn::Set(d, 0x1p30)));
}

#endif  // HWY_HAVE_FLOAT64

HWY_INLINE VI within(VI index, VI low, VI high) { return hn::Min(hn::Max(index, low), high); }
/// wrap_index() of gw/stages/texels.h of an index at most one below 0 or above the last one, if the
/// wrap repeats.
HWY_INLINE VI nearest_index(Wrap wrap, VI index, VI size) {
    const I32 d;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1);
    const auto into = [&](VI period) {
        const auto up = hn::Add(index, hn::IfThenElseZero(hn::Lt(index, zero), period));
        return hn::Sub(up, hn::IfThenZeroElse(hn::Lt(up, period), period));
    };
    switch (wrap) {
        case Wrap::Repeat: return into(size);
        case Wrap::Clamp:
        case Wrap::BorderClamp: break;
        case Wrap::ClampToBorder: return within(index, hn::Set(d, -1), size);
        case Wrap::MirroredRepeat: {
            const auto two = hn::Add(size, size), i = into(two);
            return hn::IfThenElse(hn::Lt(i, size), i, hn::Sub(hn::Sub(two, one), i));
        }
    }
    return within(index, zero, hn::Sub(size, one));
}
/// filter_index() of it.
HWY_INLINE VI linear_index(Wrap wrap, VI index, VI size) {
    return wrap == Wrap::BorderClamp ? index : nearest_index(wrap, index, size);
}
/// clamped_position() less half a texel.
HWY_INLINE VI from_first_centre(Wrap wrap, VI position, VI size) {
    const I32 d;
    if (wrap == Wrap::BorderClamp) position = within(position, hn::Zero(d), hn::ShiftLeft<8>(size));
    return hn::Sub(position, hn::Set(d, 128));
}
HWY_INLINE bool reaches_outside(Wrap wrap) {
    return wrap == Wrap::ClampToBorder || wrap == Wrap::BorderClamp;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
