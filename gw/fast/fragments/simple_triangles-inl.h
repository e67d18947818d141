// Triangles without alpha test and polygon offset: depth passes, shadow volumes, identifiers, first
// coloured passes. Tests and depth writes on vectors of 32-bit lanes, without leaving them; stencil
// operations and colour only where a fragment lives to see them. docs/manual.md, "Fragment
// operations"; the general way is gw/fast/fragments/fragments-inl.h. Included once per Highway
// target.
#if defined(GW_FAST_PLAIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_PLAIN_INL_H_
#undef GW_FAST_PLAIN_INL_H_
#else
#define GW_FAST_PLAIN_INL_H_
#endif

#include "gw/fast/fragments/paint-inl.h"
#include "gw/fast/raster/cover-inl.h"
#include "gw/stages/tables.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether a draw's triangles may go this way.
HWY_INLINE bool is_plain(const Resolved& r) {
    return r.state.alpha.func == AlphaFunc::Always && !r.state.polygon_offset.enable;
}

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
    HWY_INLINE bool of_one(std::uint32_t incoming, std::uint32_t stored) const {
        return incoming < stored;
    }
};
struct AnyCompare {
    static constexpr bool tests = true;
    DepthFunc func;
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const {
        return compare_lanes(D32(), func, incoming, stored);
    }
    HWY_INLINE bool of_one(std::uint32_t incoming, std::uint32_t stored) const {
        return compare(func, incoming, stored);
    }
};

/// Calls draw(passes) with the kind of a draw.
template <class Draw>
HWY_INLINE void with_depth_test(const DrawOp& op, const Draw& draw) {
    const DepthFunc func = op.state.state.depth.func;
    if (func == DepthFunc::Less)
        draw(LessThan{});
    else if (!needs_depth(op))
        draw(NoDepth{});
    else
        draw(AnyCompare{func});
}

/// Depth test and update of the lanes, a LaneSet or AllLanes; those that pass.
template <class Compare, class Lanes>
HWY_INLINE LaneSet run_depth(const DepthWalk& walk, const Compare& passes, bool update,
                             const Lanes& lanes, DepthBlock& block) {
    const D32 d;
    LaneSet alive;
    for (std::size_t k = 0; k < parts; ++k) {
        std::uint32_t* stored = block.value + k * lanes32;
        const auto z = walk.walk.at(k);
        alive.part[k] = among(lanes, k, passes(z, hn::Load(d, stored)));
        if (update) store_lanes(z, alive.part[k], d, stored);
    }
    return alive;
}

/// The same behind a stencil test, with the three operations: most blocks of a shadow volume change
/// nothing.
/// Where the test always passes, stencil_passed is not counted: it is made.
template <class Compare>
HWY_INLINE LaneSet run_stencil(const StencilFace& face, std::uint32_t max, const DepthWalk& walk,
                               const Compare& passes, bool update, const LaneSet& lanes,
                               StencilBlock& stencil, DepthBlock& depth, PlainCounts& counts) {
    LaneSet tested = lanes;
    if (face.func != StencilFunc::Always) {
        const std::uint32_t made = lanes.bits(), kept = stencil_test(face, stencil, made);
        tested = lane_set(kept);
        update_stencil(face, face.fail, max, stencil, made & ~kept);
        counts.stencil_passed.add(tested);
    }
    LaneSet alive = tested;
    if constexpr (Compare::tests) alive = run_depth(walk, passes, update, tested, depth);
    counts.made.add(lanes);
    const std::uint32_t passed = alive.bits();
    if (face.zfail != StencilOp::Keep)
        update_stencil(face, face.zfail, max, stencil, tested.bits() & ~passed);
    if (passed == 0) return alive;
    if (face.zpass != StencilOp::Keep) update_stencil(face, face.zpass, max, stencil, passed);
    counts.written.add(alive);
    return alive;
}

/// What becomes of a triangle's blocks where the stencil plane has no part in it. Holds copies:
/// they stay in registers.
template <class Compare, class Paint>
struct Unstenciled {
    Tile tile;
    const Compare passes;
    const Paint paint;
    const DepthWalk& walk;
    bool update;
    LaneCounter &made, &written;

    template <class Lanes>
    GW_PER_BLOCK void operator()(int bx, int by, const Lanes& lanes) const {
        made.add(lanes);
        if constexpr (Compare::tests) {
            const LaneSet alive =
                run_depth(walk, passes, update, lanes, tile.depth[tile.block(bx, by)]);
            written.add(alive);
            paint(bx, by, alive);
        } else {
            paint(bx, by, lanes);
        }
    }
};

/// One triangle of a batch. Out of line: the counters stay in registers.
template <class Way, class Compare, class Paint>
HWY_NOINLINE void draw_unstenciled(const TileDraw& draw, const Triangles& t, std::size_t i,
                                   const BoxLanes& box, const Compare& passes, const Paint& paint,
                                   PlainCounts& sum) {
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk(plane);
    LaneCounter made, written;
    made.clear(), written.clear();
    Way::visit(box, t, i, walk,
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

    GW_PER_BLOCK void operator()(int bx, int by, const LaneSet& lanes) const {
        const std::size_t block = tile.block(bx, by);
        paint(bx, by,
              run_stencil(face, max, walk, passes, update, lanes, tile.stencil[block],
                          tile.depth[block], counts));
    }
};

template <class Way, class Compare, class Paint>
HWY_NOINLINE void draw_stenciled(const TileDraw& draw, const Triangles& t, std::size_t i,
                                 const BoxLanes& box, const Compare& passes, const Paint& paint,
                                 PlainCounts& sum) {
    const Resolved& r = draw.op->state;
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk(plane);
    PlainCounts counts;
    counts.clear();
    const StencilFace& face = t.corners.primitive[i]->front ? r.front : r.back;
    Way::visit(box, t, i, walk,
               Stenciled<Compare, Paint>{draw.tile, passes, paint, walk, r.state.depth.mask, face,
                                         r.stencil_max, counts});
    if (face.func == StencilFunc::Always) counts.stencil_passed = counts.made;
    counts.add_to(sum);
}

/// Behind a stencil test only what paints nothing, as shadow volumes do, has a loop for each kind
/// of depth test.
template <class Compare, class Paint>
HWY_INLINE void draw_plain(const TileDraw& draw, const Triangles& t, std::size_t i,
                           const BoxLanes& box, const Compare& passes, const Paint& paint,
                           PlainCounts& sum) {
    const Resolved& r = draw.op->state;
    const AnyCompare any{r.state.depth.func};
    by_size(t, i, [&]<class Way>(Way) {
        if (ignores_stencil(t.corners.primitive[i]->front ? r.front : r.back))
            draw_unstenciled<Way>(draw, t, i, box, passes, paint, sum);
        else if constexpr (std::is_same_v<Paint, NoPaint>)
            draw_stenciled<Way>(draw, t, i, box, passes, paint, sum);
        else
            draw_stenciled<Way>(draw, t, i, box, any, paint, sum);
    });
}

template <class Paint>
HWY_INLINE void draw_plain(const TileDraw& draw, const Triangles& t, std::size_t i,
                           const BoxLanes& box, const Paint& paint, PlainCounts& counts) {
    with_depth_test(
        *draw.op, [&](const auto& passes) { draw_plain(draw, t, i, box, passes, paint, counts); });
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
