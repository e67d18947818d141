// Triangles without alpha test and polygon offset: depth passes, shadow volumes, identifiers, first coloured
// passes. Tests, stencil operations and depth writes on vectors of 32-bit lanes, without leaving them; colour
// only where a fragment lives. docs/manual.md, "Fragment operations"; the general way is
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

/// One face's stencil state on vectors of 32-bit lanes.
struct StencilLanes {
    using Quarter8 = hn::Rebind<std::uint8_t, D32>;
    const StencilFace& face;
    V32 ref, test_ref, test_mask, max, write_mask;

    HWY_INLINE StencilLanes(const StencilFace& f, std::uint32_t stencil_max) : face(f) {
        const D32 d;
        ref = hn::Set(d, std::uint32_t(f.ref) & 255), max = hn::Set(d, stencil_max);
        test_mask = hn::Set(d, f.mask & 255), write_mask = hn::Set(d, f.write_mask & 255);
        test_ref = hn::And(ref, test_mask);
    }
    HWY_INLINE static V32 load(const std::uint8_t* p) {
        return hn::PromoteTo(D32(), hn::Load(Quarter8(), p));
    }
    HWY_INLINE static void store(V32 v, std::uint8_t* p) {
        hn::Store(hn::DemoteTo(Quarter8(), hn::BitCast(I32(), v)), Quarter8(), p);
    }
    HWY_INLINE M32 test(V32 stored) const {
        return compare_lanes(D32(), face.func, test_ref, hn::And(stored, test_mask));
    }
    /// stencil_lanes() of gw/fast/fragments-inl.h, which saturates bytes.
    HWY_INLINE V32 result(StencilOp op, V32 stored) const {
        const D32 d;
        const auto one = hn::Set(d, 1u);
        switch (op) {
            case StencilOp::Keep: return stored;
            case StencilOp::Zero: return hn::Zero(d);
            case StencilOp::Replace: return hn::And(ref, max);
            case StencilOp::Incr: return hn::Min(hn::Add(stored, one), max);
            case StencilOp::Decr: return hn::Sub(hn::Max(stored, one), one);
            case StencilOp::Invert: return hn::AndNot(stored, max);
            case StencilOp::IncrWrap: return hn::And(hn::Add(stored, one), max);
            case StencilOp::DecrWrap: return hn::And(hn::Sub(stored, one), max);
        }
        return stored;
    }
    /// What is stored after `op`, bits outside the write mask kept.
    HWY_INLINE V32 after(StencilOp op, V32 stored) const {
        if (op == StencilOp::Keep) return stored;
        return hn::Or(hn::AndNot(write_mask, stored), hn::And(write_mask, result(op, stored)));
    }
};

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

/// The same behind a stencil test, with the three operations.
template <class Compare>
HWY_INLINE LaneSet run_stencil(const StencilLanes& s, const DepthWalk& walk, const Compare& passes,
                               bool update, const LaneSet& lanes, StencilBlock& stencil, DepthBlock& depth,
                               PlainCounts& counts) {
    V32 stored[parts];
    LaneSet tested;
    for (std::size_t k = 0; k < parts; ++k) {
        stored[k] = StencilLanes::load(stencil.value + k * lanes32);
        tested.part[k] = hn::And(lanes.part[k], s.test(stored[k]));
    }
    const LaneSet alive = run_depth(walk, passes, update, tested, depth);
    for (std::size_t k = 0; k < parts; ++k) {
        auto v = hn::IfThenElse(lanes.part[k], s.after(s.face.fail, stored[k]), stored[k]);
        v = hn::IfThenElse(tested.part[k], s.after(s.face.zfail, stored[k]), v);
        v = hn::IfThenElse(alive.part[k], s.after(s.face.zpass, stored[k]), v);
        StencilLanes::store(v, stencil.value + k * lanes32);
    }
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
        return is_flat(op.state.state) && !has_fog(op.state.state) && !op.texels && m.r && m.g && m.b &&
               m.a && (!b.enable || (b.src == BlendFactor::One && b.dst == BlendFactor::One));
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

/// One triangle of a batch, where the stencil plane has no part in it. Out of line: the counters stay in
/// registers.
template <class Compare, class Paint>
HWY_NOINLINE void draw_unstenciled(const TileDraw& draw, const Triangles& t, std::size_t i,
                                   const BoxLanes& box, const Compare& passes, const Paint& shared,
                                   PlainCounts& sum) {
    const Paint paint = shared;
    const Tile tile = draw.tile;
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk{plane, 0, {}};
    const bool update = draw.op->state.state.depth.mask;
    LaneCounter made, written;
    made.clear(), written.clear();
    const auto visit = [&](int bx, int by, auto lanes) {
        if constexpr (Compare::tests) {
            const LaneSet alive = run_depth(walk, passes, update, lanes, tile.depth[tile.block(bx, by)]);
            made.add(lanes), written.add(alive);
            paint(bx, by, alive);
        } else {
            made.add(lanes), written.add(lanes);
            paint(bx, by, lanes);
        }
    };
    visit_triangle(box, t, i, walk, visit);
    PlainCounts{made, made, written}.add_to(sum);
}

template <class Compare, class Paint>
HWY_NOINLINE void draw_stenciled(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                                 const Compare& passes, const Paint& paint, PlainCounts& sum) {
    const Resolved& r = draw.op->state;
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk{plane, 0, {}};
    const StencilLanes stencil(t.corners.primitive[i]->front ? r.front : r.back, r.stencil_max);
    const bool update = r.state.depth.mask;
    PlainCounts counts;
    counts.clear();
    visit_triangle(box, t, i, walk, [&](int bx, int by, const LaneSet& lanes) {
        const std::size_t block = draw.tile.block(bx, by);
        paint(bx, by,
              run_stencil(stencil, walk, passes, update, lanes, draw.tile.stencil[block],
                          draw.tile.depth[block], counts));
    });
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

/// Draws a batch of triangles.
inline void draw_plain(const TileDraw& draw, std::span<const std::uint32_t> bin, OpCounts& counts) {
    const BoxLanes box(draw);
    Triangles t;
    PlainCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    BatchPlanes planes(draw, t.corners);
    const bool flat = draw.op->state.writes_color && FlatPaint::serves(*draw.op);
    for (std::size_t i = 0; i < t.count(); ++i) {
        if (t.empty(i)) continue;
        if (flat)
            draw_plain(draw, t, i, box, FlatPaint(draw, *t.corners.primitive[i]), lanes);
        else if (draw.op->state.writes_color)
            draw_plain(draw, t, i, box, BatchPaint{planes, i}, lanes);
        else
            draw_plain(draw, t, i, box, NoPaint{}, lanes);
    }
    lanes.add_to(counts);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
