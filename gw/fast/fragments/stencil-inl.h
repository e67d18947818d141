// The stencil test and the stencil operations on a block. [GL11] 4.1.4; docs/manual.md, "Fragment
// operations"; scalar twin: gw/stages/tables.h. Included once per Highway target.
#if defined(GW_FAST_STENCIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_STENCIL_INL_H_
#undef GW_FAST_STENCIL_INL_H_
#else
#define GW_FAST_STENCIL_INL_H_
#endif

#include "gw/fast/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE std::uint32_t stencil_test(const StencilFace& face, const StencilBlock& block,
                                      std::uint32_t mask) {
    if (face.func == StencilFunc::Always) return mask;
    const D8 d;
    const auto ref = hn::Set(d, std::uint8_t(std::uint32_t(face.ref) & face.mask));
    const auto cut = hn::Set(d, std::uint8_t(face.mask));
    std::uint32_t pass = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes8) {
        const auto stored = hn::And(hn::Load(d, block.value + i), cut);
        pass |= bits_of(d, compare_lanes(d, face.func, ref, stored), lanes8) << i;
    }
    return pass & mask;
}

/// The operation's result on whole vectors; [GL11] 4.1.4, as in gw/stages/tables.h.
template <class D, class V>
HWY_INLINE V stencil_lanes(D d, StencilOp op, V stored, V ref, V max) {
    const V one = hn::Set(d, std::uint8_t{1});
    switch (op) {
        case StencilOp::Keep: return stored;
        case StencilOp::Zero: return hn::Zero(d);
        case StencilOp::Replace: return hn::And(ref, max);
        case StencilOp::Incr: return hn::Min(hn::SaturatedAdd(stored, one), max);
        case StencilOp::Decr: return hn::SaturatedSub(stored, one);
        case StencilOp::Invert: return hn::AndNot(stored, max);
        case StencilOp::IncrWrap: return hn::And(hn::Add(stored, one), max);
        case StencilOp::DecrWrap: return hn::And(hn::Sub(stored, one), max);
    }
    return stored;
}

HWY_NOINLINE inline void change_stencil(const StencilFace& face, StencilOp op, std::uint32_t max,
                                        StencilBlock& block, std::uint32_t mask) {
    const D8 d;
    const auto ref = hn::Set(d, std::uint8_t(face.ref)), limit = hn::Set(d, std::uint8_t(max));
    const auto writable = hn::Set(d, std::uint8_t(face.write_mask));
    for (std::size_t i = 0; i < block_pixels; i += lanes8) {
        const auto stored = hn::Load(d, block.value + i);
        const auto result = stencil_lanes(d, op, stored, ref, limit);
        const auto merged = hn::Or(hn::AndNot(writable, stored), hn::And(writable, result));
        hn::Store(hn::IfThenElse(lanes_of(d, mask, i), merged, stored), d, block.value + i);
    }
}

HWY_INLINE void update_stencil(const StencilFace& face, StencilOp op, std::uint32_t max,
                               StencilBlock& block, std::uint32_t mask) {
    if (op != StencilOp::Keep && mask != 0 && face.write_mask != 0)
        change_stencil(face, op, max, block, mask);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
