// Triangles over uniform blocks: what they paint is one colour, stored or added, or nothing, and there is no
// stencil operation. A block that one covers wholly stays uniform. The general way is gw/fast/plain-inl.h.
// Included once per Highway target.
#if defined(GW_FAST_UNIFORM_DRAW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_UNIFORM_DRAW_INL_H_
#undef GW_FAST_UNIFORM_DRAW_INL_H_
#else
#define GW_FAST_UNIFORM_DRAW_INL_H_
#endif

#include "gw/fast/uniform_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether all primitives of a bin are triangles of one depth each, as walls of a window are.
HWY_INLINE bool all_level(const GeometrySet& set, std::span<const std::uint32_t> bin) {
    return std::all_of(bin.begin(), bin.end(), [&](std::uint32_t ordinal) {
        const auto z = [&](std::size_t k) { return set.at[set.primitives[ordinal].vertex[k]].z; };
        return z(0) == z(1) && z(0) == z(2);
    });
}

/// Whether a bin's triangles go this way. Where no colour is written only level ones do: others leave no
/// block uniform.
HWY_INLINE bool draws_uniform(const DrawOp& op, std::span<const std::uint32_t> bin) {
    const Resolved& r = op.state;
    if (!is_plain(r) || !is_idle(r.front) || !is_idle(r.back)) return false;
    if (op.set->triangle_count != op.set->primitives.size()) return false;
    return r.writes_color ? FlatPaint::serves(op) : all_level(*op.set, bin);
}

struct NoColor {
    HWY_INLINE NoColor(const TileDraw&, const SetupPrimitive&) {}
    template <class Lanes>
    HWY_INLINE void operator()(int, int, UniformBlock&, const Lanes&) const {}
};

/// A triangle's one colour.
struct OneColor {
    const Rgba color;
    const FlatPaint paint;

    HWY_INLINE OneColor(const TileDraw& draw, const SetupPrimitive& p)
        : color(flat_color(draw, p)), paint(draw, color) {}

    HWY_INLINE void operator()(int bx, int by, UniformBlock& uniform, const LaneSet& alive) const {
        const std::uint32_t mask = alive.bits();
        if (mask == all_lanes) return operator()(bx, by, uniform, AllLanes{});
        if (mask == 0) return;
        settle_color(uniform, paint.store.tile.color[paint.store.tile.block(bx, by)]);
        paint(bx, by, alive);
    }
    HWY_INLINE void operator()(int bx, int by, UniformBlock& uniform, AllLanes) const {
        if (paint.store.adds && !uniform.one_color) return paint(bx, by, AllLanes{});
        const hn::CappedTag<std::uint16_t, 4> d;
        for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
            std::uint16_t* stored = uniform.color.data() + c;
            hn::Store(paint.store.result(d, hn::LoadU(d, color.data() + c), stored), d, stored);
        }
        uniform.one_color = 1;
    }
};

/// What becomes of a triangle's blocks.
template <class Depth, class Paint>
struct UniformDraw {
    Tile tile;
    const Depth depth;
    const Paint paint;
    LaneCounter &made, &written;

    template <class Lanes>
    GW_PER_BLOCK void operator()(int bx, int by, const Lanes& lanes) const {
        const std::size_t block = tile.block(bx, by);
        UniformBlock& uniform = tile.uniform[block];
        made.add(lanes);
        depth(uniform, tile.depth[block], lanes, [&](const auto& alive) {
            written.add(alive);
            paint(bx, by, uniform, alive);
        });
    }
    /// Blocks that the triangle covers wholly, counted all at once.
    HWY_INLINE void all_of(const BlockRange& r) const {
        std::uint64_t whole = 0;
        for (int by = r.y0; by <= r.y1; ++by)
            for (int bx = r.x0; bx <= r.x1; ++bx) {
                const std::size_t block = tile.block(bx, by);
                UniformBlock& uniform = tile.uniform[block];
                depth(uniform, tile.depth[block], AllLanes{}, [&](const auto& alive) {
                    if constexpr (std::is_same_v<decltype(alive), const AllLanes&>)
                        whole += 1;
                    else
                        written.add(alive);
                    paint(bx, by, uniform, alive);
                });
            }
        made.whole += std::uint64_t(r.x1 - r.x0 + 1) * std::uint64_t(r.y1 - r.y0 + 1);
        written.whole += whole;
    }
};

/// A triangle's blocks. Inlined where the walk is made: it stays in registers.
template <class Way, class Paint, class Walk, class Depth>
HWY_INLINE void draw_blocks(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                            Walk& walk, const Depth& depth, PlainCounts& sum) {
    LaneCounter made, written;
    made.clear(), written.clear();
    Way::visit(
        box, t, i, walk,
        UniformDraw<Depth, Paint>{draw.tile, depth, Paint(draw, *t.corners.primitive[i]), made, written});
    PlainCounts{made, made, written}.add_to(sum);
}

template <class Way, class Paint>
HWY_NOINLINE void draw_untested(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                                PlainCounts& sum) {
    Standing walk;
    draw_blocks<Way, Paint>(draw, t, i, box, walk, WithoutDepth{}, sum);
}
template <class Way, class Paint, class Compare>
HWY_NOINLINE void draw_level(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                             std::uint32_t z, const Compare& passes, PlainCounts& sum) {
    Standing walk;
    draw_blocks<Way, Paint>(draw, t, i, box, walk,
                            LevelDepth<Compare>{z, passes, draw.op->state.state.depth.mask}, sum);
}
template <class Way, class Paint, class Compare>
HWY_NOINLINE void draw_sloping(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                               const Compare& passes, PlainCounts& sum) {
    const DepthPlane plane = depth_of(draw, t, i);
    DepthWalk walk{plane, 0, {}};
    draw_blocks<Way, Paint>(draw, t, i, box, walk,
                            SlopingDepth<Compare>{walk, passes, draw.op->state.state.depth.mask}, sum);
}

/// Chooses the kind of triangle i's depths. Without colour all are level.
template <class Way, class Paint, class Compare>
HWY_INLINE void draw_uniform(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                             const Compare& passes, PlainCounts& sum) {
    const auto z = [&](std::size_t k) { return t.corners.z[k][i]; };
    if constexpr (!Compare::tests)
        draw_untested<Way, Paint>(draw, t, i, box, sum);
    else if (std::is_same_v<Paint, NoColor> || (z(0) == z(1) && z(0) == z(2)))
        draw_level<Way, Paint>(draw, t, i, box, z(0), passes, sum);
    else
        draw_sloping<Way, Paint>(draw, t, i, box, passes, sum);
}

template <class Paint>
HWY_INLINE void draw_uniform(const TileDraw& draw, const Triangles& t, PlainCounts& sum) {
    const BoxLanes box(draw);
    with_depth_test(*draw.op, [&](const auto& passes) {
        for (std::size_t i = 0; i < t.count(); ++i)
            if (!t.empty(i))
                by_size(t, i,
                        [&]<class Way>(Way) { draw_uniform<Way, Paint>(draw, t, i, box, passes, sum); });
    });
}

/// Draws a batch of triangles.
inline void draw_uniform(const TileDraw& draw, std::span<const std::uint32_t> bin, OpCounts& counts) {
    Triangles t;
    PlainCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op) && draw.op->state.writes_color, t);
    draw.tile.has_uniform->color |= draw.op->state.writes_color;
    draw.tile.has_uniform->depth |= draw.op->state.state.depth.mask;
    draw.op->state.writes_color ? draw_uniform<OneColor>(draw, t, lanes)
                                : draw_uniform<NoColor>(draw, t, lanes);
    lanes.add_to(counts);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
