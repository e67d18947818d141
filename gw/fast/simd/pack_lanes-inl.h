// Moves the lanes of a mask next to each other, and back to their places. Highway before 1.1 copies
// its table on each call, if there is no AVX-512. Does not know the meaning of the lanes. Included
// once per Highway target.
#if defined(GW_FAST_PACK_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_PACK_LANES_INL_H_
#undef GW_FAST_PACK_LANES_INL_H_
#else
#define GW_FAST_PACK_LANES_INL_H_
#endif

#include "gw/fast/simd/lane_orders.h"
#include "gw/fast/simd/lanes-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Up to eight lanes of a block, which one mask byte selects.
using PackedD32 = hn::CappedTag<std::uint32_t, 8>;
inline constexpr std::size_t packed_lanes = lanes32 > 8 ? 8 : lanes32;

/// Calls move(first, order, to) for each part of a block with lanes of `mask`: the lanes from `first`
/// on go to place `to` in `order`.
template <class Move>
HWY_INLINE void pack_parts(std::uint32_t mask, const Move& move) {
    constexpr std::uint32_t part = (1u << packed_lanes) - 1;
    std::size_t to = 0;
    for (std::size_t i = 0; i < block_pixels; i += packed_lanes) {
        const std::uint32_t lanes = mask >> i & part;
        if (lanes == 0) continue;
        move(i, lane_orders.packed[lanes], to);
        to += std::size_t(std::popcount(lanes));
    }
}
/// Stores the lanes of `order`, and arbitrary ones after them.
HWY_INLINE void store_packed(const float* from, const std::uint8_t* order, float* to) {
    const PackedD32 d;
    const hn::Rebind<float, PackedD32> f;
    const auto index = hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, PackedD32>(), order));
    hn::StoreU(hn::TableLookupLanes(hn::Load(f, from), hn::IndicesFromVec(f, index)), f, to);
}

/// Spreads adjacent values to the lanes of `mask`; the other lanes get arbitrary ones.
HWY_INLINE void spread_lanes(const std::uint16_t* from, std::uint32_t mask, std::uint16_t* to) {
#if HWY_TARGET == HWY_SCALAR
    for (; mask != 0; mask &= mask - 1) to[std::countr_zero(mask)] = *from++;
#else
    const hn::CappedTag<std::uint16_t, 8> d;
    for (std::size_t i = 0; i < block_pixels; i += 8) {
        const std::uint32_t lanes = mask >> i & 0xFF;
        const auto place = hn::LoadU(hn::CappedTag<std::uint8_t, 8>(), lane_orders.spread[lanes]);
        // a lane's two bytes
        const auto bytes =
            hn::Add(hn::Mul(hn::PromoteTo(d, place), hn::Set(d, std::uint16_t{0x0202})),
                    hn::Set(d, std::uint16_t{0x0100}));
        hn::Store(hn::TableLookupBytes(hn::LoadU(d, from), bytes), d, to + i);
        from += std::popcount(lanes);
    }
#endif
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
