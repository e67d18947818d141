// Triangles without alpha test: depth passes, shadow volumes, identifiers, first
// coloured passes. Tests and depth writes stay in vectors of 32-bit lanes; stencil operations and
// colour only run for fragments that reach them. docs/manual.md, "Fragment operations"; the general
// case is gw/fast/fragments/fragments-inl.h. Included once per Highway target.
#if defined(GW_FAST_SIMPLE_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SIMPLE_TRIANGLES_INL_H_
#undef GW_FAST_SIMPLE_TRIANGLES_INL_H_
#else
#define GW_FAST_SIMPLE_TRIANGLES_INL_H_
#endif

#include "gw/fast/fragments/depth-inl.h"
#include "gw/fast/fragments/lane_counts-inl.h"
#include "gw/fast/fragments/paint-inl.h"
#include "gw/fast/fragments/stencil-inl.h"
#include "gw/fast/raster/cover-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Stencil and depth test with the three stencil operations. Most blocks of a shadow volume change
/// nothing. If the stencil test always passes, stencil_passed is not counted: it equals `made`.
template <class Compare>
HWY_INLINE LaneSet run_stencil(const StencilFace& face, std::uint32_t max, const DepthWalk& walk,
                               const Compare& passes, bool update, const LaneSet& lanes,
                               StencilBlock& stencil, DepthBlock& depth, LaneCounts& counts) {
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

/// Draws a triangle's blocks if the stencil test is idle. Its members are copies, which stay in
/// registers.
template <class Compare, class Paint>
struct Unstenciled {
    static constexpr bool takes_no_lanes = Paint::takes_no_lanes;
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

/// One triangle of a batch. Not inlined, so that the counters stay in registers.
template <class Size, class Compare, class Paint>
HWY_NOINLINE void draw_unstenciled(const TileDraw& draw, const Triangles& t, std::size_t i,
                                   const BoxLanes& box, const Compare& passes, const Paint& paint,
                                   LaneCounts& sum) {
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk(plane);
    LaneCounter made, written;
    made.clear();
    written.clear();
    Size::visit(box, t, i, walk,
                Unstenciled<Compare, Paint>{draw.tile, passes, paint, walk,
                                            draw.op->state.state.depth.mask, made, written});
    LaneCounts{made, made, Compare::tests ? written : made}.add_to(sum);
}

/// Draws a triangle's blocks if the stencil test is not idle.
template <class Compare, class Paint>
struct Stenciled {
    Tile tile;
    const Compare passes;
    const Paint paint;
    const DepthWalk& walk;
    bool update;
    StencilFace face;
    std::uint32_t max;
    LaneCounts& counts;

    GW_PER_BLOCK void operator()(int bx, int by, const LaneSet& lanes) const {
        const std::size_t block = tile.block(bx, by);
        paint(bx, by,
              run_stencil(face, max, walk, passes, update, lanes, tile.stencil[block],
                          tile.depth[block], counts));
    }
};

template <class Size, class Compare, class Paint>
HWY_NOINLINE void draw_stenciled(const TileDraw& draw, const Triangles& t, std::size_t i,
                                 const BoxLanes& box, const Compare& passes, const Paint& paint,
                                 LaneCounts& sum) {
    const Resolved& r = draw.op->state;
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk(plane);
    LaneCounts counts;
    counts.clear();
    const StencilFace& face = t.corners.primitive[i]->front ? r.front : r.back;
    Size::visit(box, t, i, walk,
                Stenciled<Compare, Paint>{draw.tile, passes, paint, walk, r.state.depth.mask, face,
                                          r.stencil_max, counts});
    if (face.func == StencilFunc::Always) counts.stencil_passed = counts.made;
    counts.add_to(sum);
}

/// With a stencil test, only triangles that paint nothing (shadow volumes) have a loop for each
/// kind of depth test.
template <class Compare, class Paint>
HWY_INLINE void draw_simple(const TileDraw& draw, const Triangles& t, std::size_t i,
                            const BoxLanes& box, const Compare& passes, const Paint& paint,
                            LaneCounts& sum) {
    const Resolved& r = draw.op->state;
    const AnyCompare any{r.state.depth.func};
    by_size(t, i, [&]<class Size>(Size) {
        if (ignores_stencil(t.corners.primitive[i]->front ? r.front : r.back))
            draw_unstenciled<Size>(draw, t, i, box, passes, paint, sum);
        else if constexpr (std::is_same_v<Paint, NoPaint>)
            draw_stenciled<Size>(draw, t, i, box, passes, paint, sum);
        else
            draw_stenciled<Size>(draw, t, i, box, any, paint, sum);
    });
}

template <class Paint>
HWY_INLINE void draw_simple(const TileDraw& draw, const Triangles& t, std::size_t i,
                            const BoxLanes& box, const Paint& paint, LaneCounts& counts) {
    with_depth_test(
        *draw.op, [&](const auto& passes) { draw_simple(draw, t, i, box, passes, paint, counts); });
}

/// Draws a batch of triangles. Returns false, and does nothing, if a depth with its polygon offset
/// may leave the plane's range.
inline bool draw_simple(const TileDraw& draw, std::span<const std::uint32_t> bin,
                        OpCounts& counts) {
    const BoxLanes box(draw);
    Triangles t;
    LaneCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    if (!includes_offsets(draw, t)) return false;
    BatchPlanes planes(draw, t.corners);
    const Paints paints = paints_of(*draw.op);
    if (paints == Paints::Any && planes.may_queue()) planes.queue = &draw.scratch->queue;
    for (std::size_t i = 0; i < t.count(); ++i)
        if (!t.empty(i))
            with_paint(paints, planes, i,
                       [&](const auto& paint) { draw_simple(draw, t, i, box, paint, lanes); });
    if (planes.queue) draw_waiting(planes);
    lanes.add_to(counts);
    return true;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
