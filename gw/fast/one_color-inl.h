// Triangles of one colour without stencil operations, blending and masks: item buffers and fills. A block
// that one covers wholly stays uniform. The general way is gw/fast/plain-inl.h. Included once per Highway
// target.
#if defined(GW_FAST_ONE_COLOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_ONE_COLOR_INL_H_
#undef GW_FAST_ONE_COLOR_INL_H_
#else
#define GW_FAST_ONE_COLOR_INL_H_
#endif

#include "gw/fast/plain-inl.h"
#include "gw/fast/uniform-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether a draw's triangles go this way.
HWY_INLINE bool draws_uniform(const DrawOp& op) {
    const Resolved& r = op.state;
    return is_plain(r) && r.writes_color && FlatPaint::serves(op) && !r.state.blend.enable &&
           is_idle(r.front) && is_idle(r.back) && op.set->triangle_count == op.set->primitives.size();
}

/// run_depth() where all pixels of the block have one depth.
template <class Compare, class Lanes>
HWY_INLINE LaneSet run_first_depth(const DepthWalk& walk, const Compare& passes, bool update,
                                   const Lanes& lanes, UniformBlock& uniform, DepthBlock& block) {
    const D32 d;
    const auto stored = hn::Set(d, uniform.depth);
    LaneSet alive;
    for (std::size_t k = 0; k < parts; ++k) {
        const auto z = walk.walk.at(k);
        alive.part[k] = among(lanes, k, passes(z, stored));
        if (update) hn::Store(hn::IfThenElse(alive.part[k], z, stored), d, block.value + k * lanes32);
    }
    uniform.one_depth = update ? 0 : 1;
    return alive;
}

/// What becomes of a triangle's blocks.
template <class Compare>
struct OneColor {
    Tile tile;
    const Compare passes;
    const FlatPaint paint;
    const Rgba color;
    const DepthWalk& walk;
    bool update;
    LaneCounter &made, &written;

    template <class Lanes>
    GW_PER_BLOCK void operator()(int bx, int by, const Lanes& lanes) const {
        const std::size_t block = tile.block(bx, by);
        UniformBlock& uniform = tile.uniform[block];
        made.add(lanes);
        if constexpr (Compare::tests) {
            write(bx, by, uniform,
                  uniform.one_depth ? run_first_depth(walk, passes, update, lanes, uniform, tile.depth[block])
                                    : run_depth(walk, passes, update, lanes, tile.depth[block]));
        } else {
            write(bx, by, uniform, lanes);
        }
    }
    HWY_INLINE void write(int bx, int by, UniformBlock& uniform, const LaneSet& alive) const {
        const std::uint32_t mask = alive.bits();
        if (mask == all_lanes) return write(bx, by, uniform, AllLanes{});
        if (mask == 0) return;
        written.add(alive);
        settle_color(uniform, tile.color[tile.block(bx, by)]);
        paint(bx, by, alive);
    }
    HWY_INLINE void write(int, int, UniformBlock& uniform, AllLanes) const {
        written.add(AllLanes{});
        uniform.color = color, uniform.one_color = 1;
    }
};

template <class Way, class Compare>
HWY_NOINLINE void draw_one_color(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                                 const Compare& passes, PlainCounts& sum) {
    const SetupPrimitive& primitive = *t.corners.primitive[i];
    const DepthPlane plane = Compare::tests ? depth_of(draw, t, i) : DepthPlane{};
    DepthWalk walk{plane, 0, {}};
    LaneCounter made, written;
    made.clear(), written.clear();
    Way::visit(box, t, i, walk,
               OneColor<Compare>{draw.tile, passes, FlatPaint(draw, primitive), flat_color(draw, primitive),
                                 walk, draw.op->state.state.depth.mask, made, written});
    PlainCounts{made, made, written}.add_to(sum);
}

template <class Compare>
HWY_INLINE void draw_one_color(const TileDraw& draw, const Triangles& t, const Compare& passes,
                               PlainCounts& sum) {
    const BoxLanes box(draw);
    for (std::size_t i = 0; i < t.count(); ++i)
        if (!t.empty(i))
            by_size(t, i, [&]<class Way>(Way) { draw_one_color<Way>(draw, t, i, box, passes, sum); });
}

/// Draws a batch of triangles.
inline void draw_uniform(const TileDraw& draw, std::span<const std::uint32_t> bin, OpCounts& counts) {
    Triangles t;
    PlainCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    draw.tile.has_uniform->color = true;
    with_depth_test(*draw.op, [&](const auto& passes) { draw_one_color(draw, t, passes, lanes); });
    lanes.add_to(counts);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
