// Paints for the fragments of triangles that pass all tests: none, one colour, a smooth colour, or
// any colour of the shading stages. Each gives the same bits as the last, at less cost. Does not
// test. Included once per Highway target.
#if defined(GW_FAST_PAINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_PAINT_INL_H_
#undef GW_FAST_PAINT_INL_H_
#else
#define GW_FAST_PAINT_INL_H_
#endif

#include "gw/fast/fragments/blend-inl.h"
#include "gw/fast/fragments/flat_paint-inl.h"
#include "gw/fast/fragments/texel_queue-inl.h"
#include "gw/fast/shade/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Writes no colour.
struct NoPaint {
    static constexpr bool takes_no_lanes = parts == 1;
    HWY_INLINE void operator()(int, int, const LaneSet&) const {}
    HWY_INLINE void operator()(int, int, AllLanes) const {}
};

/// Stores a block's lanes, part by part.
struct PartStore {
    const SimpleStore& store;
    ColorBlock& block;
    hn::Mask<Half16> lanes[parts];
    bool is_plain;  ///< all lanes are stored as they are

    HWY_INLINE PartStore(const SimpleStore& s, int bx, int by, std::uint32_t alive)
        : store(s),
          block(s.tile.color[s.tile.block(bx, by)]),
          is_plain(alive == all_lanes && !s.adds) {
        for (std::size_t i = 0; i < parts; ++i) lanes[i] = lanes_of(Half16(), alive, i * lanes32);
    }
    HWY_INLINE void operator()(std::size_t channel, std::size_t part, V32 value) const {
        const Half16 d;
        std::uint16_t* const to = block.channel[channel] + part * lanes32;
        if (is_plain) return hn::Store(narrow(value), d, to);
        store_lanes(store.result(d, narrow(value), to), lanes[part], d, to);
    }
};

/// One triangle's colour from the shading stages.
struct BatchPaint {
    static constexpr bool takes_no_lanes = false;
    BatchPlanes& planes;
    std::size_t i;
    const bool is_perspective;  ///< a colour in perspective is stored or added as it is

    HWY_INLINE BatchPaint(BatchPlanes& p, std::size_t triangle)
        : planes(p),
          i(triangle),
          is_perspective(p.draw.op->perspective_color && SimpleStore::applies_to(*p.draw.op)) {}
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        if (!alive.none()) write(bx, by, alive.bits());
    }
    HWY_INLINE void operator()(int bx, int by, AllLanes) const { write(bx, by, all_lanes); }
    HWY_NOINLINE void write(int bx, int by, std::uint32_t alive) const {
        if (is_perspective) return write_perspective(bx, by, alive);
        if (waits(planes.queue, bx, by, alive)) return let_wait(planes, i, bx, by, alive);
        const TileDraw& draw = planes.draw;
        write_color(draw.op->state, planes.color_of(i, bx, by, alive),
                    draw.tile.color[draw.tile.block(bx, by)], alive);
    }
    HWY_NOINLINE void write_perspective(int bx, int by, std::uint32_t alive) const {
        planes.make();
        const SimpleStore store(planes.draw);
        const ColorPlanes& p = planes.scratch.color[i];
        PerspectiveColors& colors = planes.perspective;
        colors.aim(p, i);
        colors.at(p, planes.draw.op->state.bits, bx, by, PartStore(store, bx, by, alive));
    }
};

// If a block takes several vectors, write() is long: it is called, not inlined, to compile faster.
#undef GW_SMOOTH_WRITE
#if HWY_MAX_BYTES >= 64
#define GW_SMOOTH_WRITE HWY_INLINE
#else
#define GW_SMOOTH_WRITE HWY_NOINLINE
#endif

/// A smooth colour in narrow planes, as in a first lit pass.
struct SmoothPaint {
    static constexpr bool takes_no_lanes = false;
    SimpleStore store;
    BatchPlanes& planes;
    std::size_t triangle;

    HWY_INLINE static bool applies_to(const DrawOp& op) {
        return is_narrow(op) && SimpleStore::applies_to(op);
    }
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        if (!alive.none()) write(bx, by, alive);
    }
    GW_SMOOTH_WRITE void write(int bx, int by, const LaneSet& alive) const {
        planes.make();
        const NarrowBatch& p = planes.narrow_color;
        const PartStore put(store, bx, by, alive.bits());
        for (std::size_t c = 0; c < 4; ++c)
            narrow_block(p.c[c][triangle], p.gx[c][triangle], p.gy[c][triangle], bx, by,
                         [&](std::size_t part, V32 value) { put(c, part, value); });
    }
    HWY_INLINE void operator()(int bx, int by, AllLanes) const {
        operator()(bx, by, lane_set(all_lanes));
    }
};

/// The paint of a draw's triangles.
enum class Paints { Nothing, OneColor, Smooth, Any };
HWY_INLINE Paints paints_of(const DrawOp& op) {
    if (!op.state.writes_color) return Paints::Nothing;
    if (FlatPaint::applies_to(op)) return Paints::OneColor;
    return SmoothPaint::applies_to(op) ? Paints::Smooth : Paints::Any;
}
/// Calls draw(paint) for triangle i of a batch.
template <class Draw>
HWY_INLINE void with_paint(Paints paints, BatchPlanes& planes, std::size_t i, const Draw& draw) {
    switch (paints) {
        case Paints::Nothing: return draw(NoPaint{});
        case Paints::OneColor:
            return draw(
                FlatPaint(planes.draw, one_color(planes.draw, *planes.corners.primitive[i])));
        case Paints::Smooth: return draw(SmoothPaint{SimpleStore(planes.draw), planes, i});
        case Paints::Any: return draw(BatchPaint(planes, i));
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
