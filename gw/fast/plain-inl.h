// Triangles without alpha test and polygon offset: depth passes, shadow volumes, identifiers, first coloured
// passes. Tests and depth writes on vectors of 32-bit lanes, without leaving them; stencil operations and
// colour only where a fragment lives to see them. docs/manual.md, "Fragment operations"; the general way is
// gw/fast/fragments-inl.h. Included once per Highway target.
#if defined(GW_FAST_PLAIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_PLAIN_INL_H_
#undef GW_FAST_PLAIN_INL_H_
#else
#define GW_FAST_PLAIN_INL_H_
#endif

#include "gw/fast/batch-inl.h"
#include "gw/fast/cover-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether a draw's triangles may go this way.
HWY_INLINE bool is_plain(const Resolved& r) {
    return r.state.alpha.func == AlphaFunc::Always && !r.state.polygon_offset.enable;
}

HWY_INLINE bool is_idle(const StencilFace& f) { return f.func == StencilFunc::Always && keeps(f); }

/// A triangle's fragments by fate, lane by lane.
struct PlainCounts {
    LaneCounter made, stencil_passed, written;
    HWY_INLINE void clear() { made.clear(), stencil_passed.clear(), written.clear(); }
    HWY_INLINE void add_to(PlainCounts& sum) const {
        sum.made.add(made), sum.stencil_passed.add(stencil_passed), sum.written.add(written);
    }
    HWY_INLINE void add_to(OpCounts& counts) const {
        const std::uint64_t f = made.total(), s = stencil_passed.total(), w = written.total();
        counts.fragments += f, counts.stencil_killed += f - s, counts.depth_killed += s - w,
            counts.written += w;
    }
};

/// The depth test, of three kinds so that the loop has no choice to make.
struct NoDepth {
    static constexpr bool tests = false;
    HWY_INLINE M32 operator()(V32, V32) const { return hn::FirstN(D32(), lanes32); }
};
struct LessThan {
    static constexpr bool tests = true;
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const { return hn::Lt(incoming, stored); }
};
struct AnyCompare {
    static constexpr bool tests = true;
    DepthFunc func;
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const {
        return compare_lanes(D32(), func, incoming, stored);
    }
};

/// Depth test and update of the lanes; those that pass.
template <class Compare>
HWY_INLINE LaneSet run_depth(const DepthWalk& walk, const Compare& passes, bool update, const LaneSet& lanes,
                             DepthBlock& block) {
    if constexpr (!Compare::tests) return lanes;
    const D32 d;
    LaneSet alive;
    for (std::size_t k = 0; k < parts; ++k) {
        std::uint32_t* stored = block.value + k * lanes32;
        const auto z = walk.walk.at(k);
        alive.part[k] = hn::And(lanes.part[k], passes(z, hn::Load(d, stored)));
        if (update) hn::BlendedStore(z, alive.part[k], d, stored);
    }
    return alive;
}

/// The same of all lanes.
template <class Compare>
HWY_INLINE LaneSet run_depth(const DepthWalk& walk, const Compare& passes, bool update, AllLanes,
                             DepthBlock& block) {
    const D32 d;
    LaneSet alive;
    for (std::size_t k = 0; k < parts; ++k) {
        std::uint32_t* stored = block.value + k * lanes32;
        const auto z = walk.walk.at(k);
        alive.part[k] = passes(z, hn::Load(d, stored));
        if (update) hn::BlendedStore(z, alive.part[k], d, stored);
    }
    return alive;
}

/// The same behind a stencil test, with the three operations: most blocks of a shadow volume change nothing.
template <class Compare>
HWY_INLINE LaneSet run_stencil(const StencilFace& face, std::uint32_t max, const DepthWalk& walk,
                               const Compare& passes, bool update, const LaneSet& lanes,
                               StencilBlock& stencil, DepthBlock& depth, PlainCounts& counts) {
    LaneSet tested = lanes;
    if (face.func != StencilFunc::Always) {
        const std::uint32_t made = lanes.bits(), kept = stencil_test(face, stencil, made);
        tested = lane_set(kept);
        update_stencil(face, face.fail, max, stencil, made & ~kept);
    }
    const LaneSet alive = run_depth(walk, passes, update, tested, depth);
    if (face.zfail != StencilOp::Keep)
        update_stencil(face, face.zfail, max, stencil, tested.bits() & ~alive.bits());
    if (face.zpass != StencilOp::Keep) update_stencil(face, face.zpass, max, stencil, alive.bits());
    counts.made.add(lanes), counts.stencil_passed.add(tested), counts.written.add(alive);
    return alive;
}

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

/// A triangle of one colour, stored or added: what item buffers and fills do. A loop over blocks holds a copy
/// of its own, which stays in registers.
struct FlatPaint {
    const Resolved* state;
    Tile tile;
    bool adds;
    std::uint16_t max;
    ColorBlock color;

    HWY_INLINE FlatPaint(const TileDraw& draw, const SetupPrimitive& p)
        : state(&draw.op->state),
          tile(draw.tile),
          adds(state->state.blend.enable),
          max(std::uint16_t(max_of_bits(state->bits))) {
        const D16 d16;
        const Rgba c = flat_color(draw, p);
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < block_pixels; i += lanes16)
                hn::Store(hn::Set(d16, c[k]), d16, color.channel[k] + i);
    }
    HWY_INLINE static bool serves(const DrawOp& op) {
        const BlendState& b = op.state.state.blend;
        const ColorMask& m = op.state.state.color_mask;
        return is_flat(op) && !has_fog(op.state.state) && !op.texels && m.r && m.g && m.b && m.a &&
               (!b.enable || (b.src == BlendFactor::One && b.dst == BlendFactor::One));
    }
    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        const std::uint32_t mask = alive.bits();
        if (mask == all_lanes) return operator()(bx, by, AllLanes{});
        if (mask == 0) return;
        const ColorBlock copy = color;
        write_color(*state, copy, tile.color[tile.block(bx, by)], mask);
    }
    /// All 16 pixels, four channels in a row.
    HWY_INLINE void operator()(int bx, int by, AllLanes) const {
        const hn::CappedTag<std::uint16_t, 32> d;
        const auto most = hn::Set(d, max);
        std::uint16_t* to = tile.color[tile.block(bx, by)].channel[0];
        for (std::size_t i = 0; i < 4 * block_pixels; i += hn::Lanes(d)) {
            const auto own = hn::Load(d, color.channel[0] + i);
            hn::Store(adds ? hn::Min(hn::SaturatedAdd(own, hn::Load(d, to + i)), most) : own, d, to + i);
        }
    }
};

/// What becomes of a triangle's blocks where the stencil plane has no part in it. Holds copies: they stay in
/// registers.
template <class Compare, class Paint>
struct Unstenciled {
    Tile tile;
    const Compare passes;
    const Paint paint;
    const DepthWalk& walk;
    bool update;
    LaneCounter &made, &written;

    template <class Lanes>
    HWY_INLINE void operator()(int bx, int by, const Lanes& lanes) const {
        made.add(lanes);
        if constexpr (Compare::tests) {
            const LaneSet alive = run_depth(walk, passes, update, lanes, tile.depth[tile.block(bx, by)]);
            written.add(alive);
            paint(bx, by, alive);
        } else {
            paint(bx, by, lanes);
        }
    }
};

/// One triangle of a batch. Out of line: the counters stay in registers.
template <class Compare, class Paint>
HWY_NOINLINE void draw_unstenciled(const TileDraw& draw, const Triangles& t, std::size_t i,
                                   const BoxLanes& box, const Compare& passes, const Paint& paint,
                                   PlainCounts& sum) {
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk{plane, 0, {}};
    LaneCounter made, written;
    made.clear(), written.clear();
    visit_triangle(box, t, i, walk,
                   Unstenciled<Compare, Paint>{draw.tile, passes, paint, walk,
                                               draw.op->state.state.depth.mask, made, written});
    PlainCounts{made, made, Compare::tests ? written : made}.add_to(sum);
}

/// The same where it has.
template <class Compare, class Paint>
struct Stenciled {
    Tile tile;
    const Compare passes;
    const Paint paint;
    const DepthWalk& walk;
    bool update;
    StencilFace face;
    std::uint32_t max;
    PlainCounts& counts;

    HWY_INLINE void operator()(int bx, int by, const LaneSet& lanes) const {
        const std::size_t block = tile.block(bx, by);
        paint(bx, by,
              run_stencil(face, max, walk, passes, update, lanes, tile.stencil[block], tile.depth[block],
                          counts));
    }
};

template <class Compare, class Paint>
HWY_NOINLINE void draw_stenciled(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                                 const Compare& passes, const Paint& paint, PlainCounts& sum) {
    const Resolved& r = draw.op->state;
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk{plane, 0, {}};
    PlainCounts counts;
    counts.clear();
    visit_triangle(
        box, t, i, walk,
        Stenciled<Compare, Paint>{draw.tile, passes, paint, walk, r.state.depth.mask,
                                  t.corners.primitive[i]->front ? r.front : r.back, r.stencil_max, counts});
    counts.add_to(sum);
}

template <class Compare, class Paint>
HWY_INLINE void draw_plain(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                           const Compare& passes, const Paint& paint, PlainCounts& sum) {
    const Resolved& r = draw.op->state;
    if (is_idle(t.corners.primitive[i]->front ? r.front : r.back))
        draw_unstenciled(draw, t, i, box, passes, paint, sum);
    else
        draw_stenciled(draw, t, i, box, passes, paint, sum);
}

template <class Paint>
HWY_INLINE void draw_plain(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                           const Paint& paint, PlainCounts& counts) {
    const DepthState& depth = draw.op->state.state.depth;
    if (depth.func == DepthFunc::Less)
        draw_plain(draw, t, i, box, LessThan{}, paint, counts);
    else if (depth.func == DepthFunc::Always && !depth.mask)
        draw_plain(draw, t, i, box, NoDepth{}, paint, counts);
    else
        draw_plain(draw, t, i, box, AnyCompare{depth.func}, paint, counts);
}

/// What a draw's triangles paint with.
enum class Paints { Nothing, OneColor, Planes };
HWY_INLINE Paints paints_of(const DrawOp& op) {
    if (!op.state.writes_color) return Paints::Nothing;
    return FlatPaint::serves(op) ? Paints::OneColor : Paints::Planes;
}
/// Calls draw(paint) for triangle i of a batch.
template <class Draw>
HWY_INLINE void with_paint(Paints paints, BatchPlanes& planes, std::size_t i, const Draw& draw) {
    switch (paints) {
        case Paints::Nothing: return draw(NoPaint{});
        case Paints::OneColor: return draw(FlatPaint(planes.draw, *planes.corners.primitive[i]));
        case Paints::Planes: return draw(BatchPaint{planes, i});
    }
}

/// Draws a batch of triangles.
inline void draw_plain(const TileDraw& draw, std::span<const std::uint32_t> bin, OpCounts& counts) {
    const BoxLanes box(draw);
    Triangles t;
    PlainCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    BatchPlanes planes(draw, t.corners);
    const Paints paints = paints_of(*draw.op);
    for (std::size_t i = 0; i < t.count(); ++i)
        if (!t.empty(i))
            with_paint(paints, planes, i,
                       [&](const auto& paint) { draw_plain(draw, t, i, box, paint, lanes); });
    lanes.add_to(counts);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
