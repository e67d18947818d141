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

/// Stores or adds colours that need no texture, no secondary colour and no fog.
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
        return !has_fog(op.state.state) && !op.sums_colors && !op.texels &&
               op.state.writes_whole_color && !op.state.state.logic_op.enable &&
               (!b.enable || adds_colors(b));
    }
    template <class D>
    HWY_INLINE hn::Vec<D> result(D d, hn::Vec<D> own, const std::uint16_t* stored) const {
        return adds ? hn::Min(hn::SaturatedAdd(own, hn::Load(d, stored)), hn::Set(d, max)) : own;
    }
};

/// A triangle of one colour, as in item buffers and fills. Each loop over blocks copies it, so that
/// it stays in registers.
struct FlatPaint {
    /// Masked stores cost the same for any lanes.
    static constexpr bool takes_no_lanes = parts == 1;
    using D = hn::CappedTag<std::uint16_t, 32>;
    static constexpr std::size_t vectors = HWY_MAX_BYTES >= 64 ? 2 : 4 * block_pixels / lanes16;
    SimpleStore store;
    hn::Vec<D> color[vectors];  ///< the channels one after the other, as in a ColorBlock

    HWY_INLINE FlatPaint(const TileDraw& draw, const Rgba& c) : store(draw) {
        const D d;
        for (std::size_t k = 0; k < vectors; ++k) {
            const std::size_t channel = k * hn::Lanes(d) / block_pixels;
            color[k] = hn::Set(d, c[channel]);
            if constexpr (vectors == 2)
                color[k] = hn::IfThenElse(hn::FirstN(d, block_pixels), color[k],
                                          hn::Set(d, c[channel + 1]));
        }
    }
    HWY_INLINE static bool applies_to(const DrawOp& op) {
        return is_flat(op) && SimpleStore::applies_to(op);
    }
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        const std::uint32_t mask = alive.bits();
        if constexpr (takes_no_lanes) return write_lanes(bx, by, mask);
        if (mask == all_lanes) return operator()(bx, by, AllLanes{});
        if (mask != 0) write_lanes(bx, by, mask);
    }
    /// Four channels one after the other, with the same lanes.
    HWY_INLINE void write_lanes(int bx, int by, std::uint32_t mask) const {
        for_each_vector(bx, by, [&](std::size_t i, auto result, std::uint16_t* to) {
            store_lanes(result, lanes_of(D(), mask | mask << block_pixels, i % block_pixels), D(),
                        to);
        });
    }
    /// The same to a block whose lanes have the values of `stored` so far.
    HWY_INLINE void write_lanes(const ColorBlock& stored, ColorBlock& block,
                                std::uint32_t mask) const {
        constexpr std::size_t each = vectors < 4 ? 1 : vectors / 4;
        const D d;
        hn::Mask<D> lanes[each];
        for (std::size_t k = 0; k < each; ++k)
            lanes[k] = lanes_of(d, mask | mask << block_pixels, k * hn::Lanes(d));
        const std::uint16_t* from = stored.channel[0];
        std::uint16_t* to = block.channel[0];
        for (std::size_t k = 0; k < vectors; ++k, from += hn::Lanes(d), to += hn::Lanes(d)) {
            const auto result = store.result(d, color[k], from);
            hn::Store(hn::IfThenElse(lanes[k % each], result, hn::Load(d, from)), d, to);
        }
    }
    HWY_INLINE void operator()(int bx, int by, AllLanes) const {
        for_each_vector(bx, by, [&](std::size_t, auto result, std::uint16_t* to) {
            hn::Store(result, D(), to);
        });
    }

private:
    HWY_INLINE void for_each_vector(int bx, int by, const auto& put) const {
        std::uint16_t* to = store.tile.color[store.tile.block(bx, by)].channel[0];
        for (std::size_t k = 0; k < vectors; ++k, to += hn::Lanes(D()))
            put(k * hn::Lanes(D()), store.result(D(), color[k], to), to);
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
