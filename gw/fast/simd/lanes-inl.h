// A block's 16 lanes as vectors of 8, 16 and 32 bits, masks of them, and products of channels. Does
// not know the meaning of the lanes. Included once per Highway target.
#if defined(GW_FAST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_LANES_INL_H_
#undef GW_FAST_LANES_INL_H_
#else
#define GW_FAST_LANES_INL_H_
#endif

#include "gw/fast/frame/frame.h"
#include "gw/state.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::CappedTag<std::uint8_t, 16>;
using D16 = hn::CappedTag<std::uint16_t, 16>;
using D32 = hn::CappedTag<std::uint32_t, 16>;
using I32 = hn::Rebind<std::int32_t, D32>;
using F32 = hn::Rebind<float, D32>;
using Half16 = hn::Rebind<std::uint16_t, D32>;  // as many 16-bit lanes as D32 has 32-bit ones
using V32 = hn::Vec<D32>;
using M32 = hn::Mask<D32>;

constexpr std::uint32_t all_lanes = 0xFFFF;
inline constexpr std::size_t lanes32 = HWY_MAX_BYTES >= 64   ? 16
                                       : HWY_MAX_BYTES >= 32 ? 8
                                       : HWY_MAX_BYTES >= 16 ? 4
                                                             : 1;
inline constexpr std::size_t lanes16 = lanes32 == 1 ? 1 : lanes32 * 2 > 16 ? 16 : lanes32 * 2;
inline constexpr std::size_t lanes8 = lanes32 == 1 ? 1 : 16;

/// Lanes of a vector's mask, from bit `first` of a block's 16-bit mask.
template <class D>
HWY_INLINE hn::Mask<D> lanes_of(D d, std::uint32_t mask, std::size_t first) {
    const std::uint64_t bits = mask >> first;
    return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
}

/// A vector's mask as bits.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> m, std::size_t lanes) {
    std::uint64_t bits = 0;
#if HWY_TARGET == HWY_WASM  // Highway before 1.1 goes through memory
    constexpr std::size_t size = sizeof(hn::TFromD<D>);
    bits = std::uint64_t(size == 1   ? wasm_i8x16_bitmask(m.raw)
                         : size == 2 ? wasm_i16x8_bitmask(m.raw)
                         : size == 4 ? wasm_i32x4_bitmask(m.raw)
                                     : wasm_i64x2_bitmask(m.raw));
#elif HWY_TARGET <= HWY_AVX3  // not by way of memory, where two bytes that are read as four wait
    bits = std::uint64_t{m.raw};
#else
    hn::StoreMaskBits(d, m, reinterpret_cast<std::uint8_t*>(&bits));
#endif
    return static_cast<std::uint32_t>(bits) & ((1u << lanes) - 1);
}

/// Stores the lanes of a mask. Targets without masked stores rewrite the other lanes unchanged.
/// This is safe because only one thread draws a tile.
template <class D>
HWY_INLINE void store_lanes(hn::Vec<D> v, hn::Mask<D> lanes, D d, hn::TFromD<D>* p) {
#if HWY_TARGET <= HWY_AVX3
    hn::BlendedStore(v, lanes, d, p);
#else
    hn::StoreU(hn::IfThenElse(lanes, v, hn::LoadU(d, p)), d, p);
#endif
}

/// Loads a block's channel, 16 bits a lane, as 32 bits a lane; store16 reverses it.
HWY_INLINE V32 load_channel(const std::uint16_t* p) {
    return hn::PromoteTo(D32(), hn::Load(Half16(), p));
}
HWY_INLINE hn::Vec<Half16> narrow(V32 v) { return hn::DemoteTo(Half16(), hn::BitCast(I32(), v)); }
HWY_INLINE void store16(V32 v, std::uint16_t* p) { hn::Store(narrow(v), Half16(), p); }

/// mul(a, b, n) of gw/base/arithmetic.h.
HWY_INLINE V32 mul_lanes(V32 a, V32 b, int n) {
    const D32 d;
    const auto t = hn::Add(hn::Mul(a, b), hn::Set(d, 1u << (n - 1)));
    return hn::ShiftRightSame(hn::Add(t, hn::ShiftRightSame(t, n)), n);
}
/// The same for n = 8 in 16-bit lanes.
template <class D>
HWY_INLINE hn::Vec<D> mul_bytes(D d, hn::Vec<D> a, hn::Vec<D> b) {
    const auto t = hn::Add(hn::Mul(a, b), hn::Set(d, std::uint16_t{128}));
    return hn::ShiftRight<8>(hn::Add(t, hn::ShiftRight<8>(t)));
}

/// incoming func stored, as in gw/stages/tables.h.
template <class D, class V>
HWY_INLINE hn::Mask<D> compare_lanes(D d, CompareFunc func, V incoming, V stored) {
    switch (func) {
        case CompareFunc::Never: return hn::FirstN(d, 0);
        case CompareFunc::Less: return hn::Lt(incoming, stored);
        case CompareFunc::Equal: return hn::Eq(incoming, stored);
        case CompareFunc::LEqual: return hn::Not(hn::Lt(stored, incoming));
        case CompareFunc::Greater: return hn::Lt(stored, incoming);
        case CompareFunc::NotEqual: return hn::Not(hn::Eq(incoming, stored));
        case CompareFunc::GEqual: return hn::Not(hn::Lt(incoming, stored));
        case CompareFunc::Always: break;
    }
    return hn::FirstN(d, hn::Lanes(d));
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
