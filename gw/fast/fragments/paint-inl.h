// What triangles paint their living fragments with: nothing, one colour, a smooth colour, or
// anything that the stages can make. Each does the same as the last, for less. Does not test.
// Included once per Highway target.
#if defined(GW_FAST_PAINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_PAINT_INL_H_
#undef GW_FAST_PAINT_INL_H_
#else
#define GW_FAST_PAINT_INL_H_
#endif

#include "gw/fast/shade/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// No plane of colour is written.
struct NoPaint {
    HWY_INLINE void operator()(int, int, const LaneSet&) const {}
    HWY_INLINE void operator()(int, int, AllLanes) const {}
};

/// One triangle's colour, as the batch has it.
struct BatchPaint {
    BatchPlanes& planes;
    std::size_t i;

    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        if (!alive.none()) write(bx, by, alive.bits());
    }
    HWY_INLINE void operator()(int bx, int by, AllLanes) const { write(bx, by, all_lanes); }
    HWY_NOINLINE void write(int bx, int by, std::uint32_t alive) const {
        const TileDraw& draw = planes.draw;
        write_color(draw.op->state, planes.color_of(i, bx, by, alive),
                    draw.tile.color[draw.tile.block(bx, by)], alive);
    }
};

/// How colours that need no texture and no fog reach the frame buffer: stored, or added.
struct PlainStore {
    Tile tile;
    bool adds;
    std::uint16_t max;

    HWY_INLINE explicit PlainStore(const TileDraw& draw)
        : tile(draw.tile),
          adds(draw.op->state.state.blend.enable),
          max(std::uint16_t(max_of_bits(draw.op->state.bits))) {}
    HWY_INLINE static bool serves(const DrawOp& op) {
        const BlendState& b = op.state.state.blend;
        const ColorMask& m = op.state.state.color_mask;
        return !has_fog(op.state.state) && !op.texels && m.r && m.g && m.b && m.a &&
               (!b.enable || (b.src == BlendFactor::One && b.dst == BlendFactor::One));
    }
    template <class D>
    HWY_INLINE hn::Vec<D> result(D d, hn::Vec<D> own, const std::uint16_t* stored) const {
        return adds ? hn::Min(hn::SaturatedAdd(own, hn::Load(d, stored)), hn::Set(d, max)) : own;
    }
};

/// A triangle of one colour: what item buffers and fills do. A loop over blocks holds a copy of its
/// own, which stays in registers.
struct FlatPaint {
    PlainStore store;
    ColorBlock color;

    HWY_INLINE FlatPaint(const TileDraw& draw, const Rgba& c) : store(draw) {
        const D16 d16;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < block_pixels; i += lanes16)
                hn::Store(hn::Set(d16, c[k]), d16, color.channel[k] + i);
    }
    HWY_INLINE static bool serves(const DrawOp& op) {
        return is_flat(op) && PlainStore::serves(op);
    }
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        const std::uint32_t mask = alive.bits();
        if (mask == all_lanes) return operator()(bx, by, AllLanes{});
        if (mask != 0) some(bx, by, mask);
    }
    /// Four channels in a row, which have the same lanes.
    HWY_INLINE void some(int bx, int by, std::uint32_t mask) const {
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

// Long where a block takes more than one vector: called there, for the time that compiling takes.
#undef GW_SMOOTH_WRITE
#if HWY_MAX_BYTES >= 64
#define GW_SMOOTH_WRITE HWY_INLINE
#else
#define GW_SMOOTH_WRITE HWY_NOINLINE
#endif

/// A triangle of a smooth colour in narrow planes: a first lit pass.
struct SmoothPaint {
    PlainStore store;
    BatchPlanes& planes;
    std::size_t triangle;

    HWY_INLINE static bool serves(const DrawOp& op) {
        return is_narrow(op) && PlainStore::serves(op);
    }
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        if (!alive.none()) write(bx, by, alive);
    }
    GW_SMOOTH_WRITE void write(int bx, int by, const LaneSet& alive) const {
        planes.make();
        const Half16 d;
        const NarrowBatch& p = planes.narrow_color;
        ColorBlock& stored = store.tile.color[store.tile.block(bx, by)];
        for (std::size_t i = 0; i < parts; ++i) {
            const Pixels at = pixels_of(bx, by, i * lanes32);
            const auto lanes = lanes_of(d, alive.bits(), i * lanes32);
            for (std::size_t c = 0; c < 4; ++c) {
                const auto coefficient = [&](const auto& of) {
                    return hn::Set(D32(), of[c][triangle]);
                };
                const auto v =
                    narrow_value(coefficient(p.c), coefficient(p.gx), coefficient(p.gy), at);
                std::uint16_t* to = stored.channel[c] + i * lanes32;
                store_lanes(store.result(d, narrow(v), to), lanes, d, to);
            }
        }
    }
    HWY_INLINE void operator()(int bx, int by, AllLanes) const {
        operator()(bx, by, lane_set(all_lanes));
    }
};

/// What a draw's triangles paint with.
enum class Paints { Nothing, OneColor, Smooth, Any };
HWY_INLINE Paints paints_of(const DrawOp& op) {
    if (!op.state.writes_color) return Paints::Nothing;
    if (FlatPaint::serves(op)) return Paints::OneColor;
    return SmoothPaint::serves(op) ? Paints::Smooth : Paints::Any;
}
/// Calls draw(paint) for triangle i of a batch.
template <class Draw>
HWY_INLINE void with_paint(Paints paints, BatchPlanes& planes, std::size_t i, const Draw& draw) {
    switch (paints) {
        case Paints::Nothing: return draw(NoPaint{});
        case Paints::OneColor:
            return draw(
                FlatPaint(planes.draw, flat_color(planes.draw, *planes.corners.primitive[i])));
        case Paints::Smooth: return draw(SmoothPaint{PlainStore(planes.draw), planes, i});
        case Paints::Any: return draw(BatchPaint{planes, i});
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
