// Painting with one colour, stored or added: item buffers and fills. Does not test. Included once
// per Highway target.
#if defined(GW_FAST_FLAT_PAINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_FLAT_PAINT_INL_H_
#undef GW_FAST_FLAT_PAINT_INL_H_
#else
#define GW_FAST_FLAT_PAINT_INL_H_
#endif

#include "gw/fast/shade/colors-inl.h"
#include "gw/fast/simd/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Stores or adds colours that need no texture and no fog.
struct SimpleStore {
    Tile tile;
    bool adds;
    std::uint16_t max;

    HWY_INLINE explicit SimpleStore(const TileDraw& draw)
        : tile(draw.tile),
          adds(draw.op->state.state.blend.enable),
          max(std::uint16_t(max_of_bits(draw.op->state.bits))) {}
    HWY_INLINE static bool applies_to(const DrawOp& op) {
        const BlendState& b = op.state.state.blend;
        const ColorMask& m = op.state.state.color_mask;
        return !has_fog(op.state.state) && !op.texels && m.r && m.g && m.b && m.a &&
               !op.state.state.logic_op.enable && (!b.enable || adds_colors(b));
    }
    template <class D>
    HWY_INLINE hn::Vec<D> result(D d, hn::Vec<D> own, const std::uint16_t* stored) const {
        return adds ? hn::Min(hn::SaturatedAdd(own, hn::Load(d, stored)), hn::Set(d, max)) : own;
    }
};

/// A triangle of one colour, as in item buffers and fills. Each loop over blocks copies it, so that
/// it stays in registers.
struct FlatPaint {
    SimpleStore store;
    ColorBlock color;

    HWY_INLINE FlatPaint(const TileDraw& draw, const Rgba& c) : store(draw) {
        const D16 d16;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < block_pixels; i += lanes16)
                hn::Store(hn::Set(d16, c[k]), d16, color.channel[k] + i);
    }
    HWY_INLINE static bool applies_to(const DrawOp& op) {
        return is_flat(op) && SimpleStore::applies_to(op);
    }
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        const std::uint32_t mask = alive.bits();
        if (mask == all_lanes) return operator()(bx, by, AllLanes{});
        if (mask != 0) write_lanes(bx, by, mask);
    }
    /// Four channels one after the other, with the same lanes.
    HWY_INLINE void write_lanes(int bx, int by, std::uint32_t mask) const {
        const hn::CappedTag<std::uint16_t, 32> d;
        for_each_vector(bx, by, [&](std::size_t i, auto result, std::uint16_t* to) {
            store_lanes(result, lanes_of(d, mask | mask << block_pixels, i % block_pixels), d, to);
        });
    }
    HWY_INLINE void operator()(int bx, int by, AllLanes) const {
        const hn::CappedTag<std::uint16_t, 32> d;
        for_each_vector(
            bx, by, [&](std::size_t, auto result, std::uint16_t* to) { hn::Store(result, d, to); });
    }

private:
    HWY_INLINE void for_each_vector(int bx, int by, const auto& put) const {
        const hn::CappedTag<std::uint16_t, 32> d;
        const std::uint16_t* from = color.channel[0];
        std::uint16_t* to = store.tile.color[store.tile.block(bx, by)].channel[0];
        for (std::size_t i = 0; i < 4 * block_pixels; i += hn::Lanes(d))
            put(i, store.result(d, hn::Load(d, from + i), to + i), to + i);
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
