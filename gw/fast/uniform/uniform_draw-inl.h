// Triangles over uniform blocks, without stencil operations. They store or add one colour, or write
// no colour. A block that a large triangle covers wholly stays uniform. Other triangles:
// gw/fast/fragments/simple_triangles-inl.h. Included once per Highway target.
#if defined(GW_FAST_UNIFORM_DRAW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_UNIFORM_DRAW_INL_H_
#undef GW_FAST_UNIFORM_DRAW_INL_H_
#else
#define GW_FAST_UNIFORM_DRAW_INL_H_
#endif

#include "gw/fast/fragments/simple_triangles-inl.h"
#include "gw/fast/uniform/level_depth-inl.h"
#include "gw/fast/uniform/sloping_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether each primitive of a bin is a triangle with one depth, as of a wall parallel to the
/// window.
HWY_INLINE bool all_level(const GeometrySet& set, std::span<const std::uint32_t> bin) {
    return std::all_of(bin.begin(), bin.end(), [&](std::uint32_t ordinal) {
        const auto z = [&](std::size_t k) { return set.at[set.primitives[ordinal].vertex[k]].z; };
        return z(0) == z(1) && z(0) == z(2);
    });
}

/// Whether all primitives are triangles over many blocks, so that most blocks are covered wholly.
HWY_INLINE bool all_large(const GeometrySet& set, std::span<const std::uint32_t> bin,
                          int subpixel_bits) {
    const std::int64_t side = std::int64_t{8 * block_side} << subpixel_bits;
    return std::all_of(bin.begin(), bin.end(), [&](std::uint32_t ordinal) {
        const auto corner = [&](std::size_t k) {
            return set.at[set.primitives[ordinal].vertex[k]];
        };
        const SnappedVertex a = corner(0), b = corner(1), c = corner(2);
        const std::int64_t twice_area =
            std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
        return std::abs(twice_area) >= side * side;
    });
}

/// Whether a bin's triangles are drawn this way. Without colour only level and large triangles are:
/// others leave few blocks uniform.
HWY_INLINE bool draws_uniform(const DrawOp& op, std::span<const std::uint32_t> bin,
                              int subpixel_bits) {
    const Resolved& r = op.state;
    if (!takes_simple_path(op) || !ignores_stencil(r.front) || !ignores_stencil(r.back))
        return false;
    if (!is_filled(op)) return false;
    if (r.writes_color) return FlatPaint::applies_to(op);
    return all_level(*op.set, bin) || all_large(*op.set, bin, subpixel_bits);
}

/// Writes back a group's blocks that `blocks` has, a bit each; (x, y) is its lowest block.
HWY_NOINLINE inline void write_back_group(const Tile& tile, int x, int y, std::uint32_t colors,
                                          std::uint32_t depths) {
    for (; colors != 0; colors &= colors - 1) {
        const int i = std::countr_zero(colors);
        write_back_color(tile, x + i % group_blocks, y + i / group_blocks);
    }
    for (; depths != 0; depths &= depths - 1) {
        const int i = std::countr_zero(depths);
        write_back_depth(tile, x + i % group_blocks, y + i / group_blocks);
    }
}

/// Writes back the blocks of a range. has_uniform stays: other blocks may be uniform.
HWY_INLINE void write_back_range(const Tile& tile, UniformPlanes which, const BlockRange& r) {
    const UniformPlanes& has = *tile.has_uniform;
    which = {which.color && has.color, which.depth && has.depth};
    if (!which.color && !which.depth) return;
    const int first = group_blocks - 1;
    for (int y = r.y0 & ~first; y <= r.y1; y += group_blocks)
        for (int x = r.x0 & ~first; x <= r.x1; x += group_blocks) {
            const UniformGroup& group = tile.group(x, y);
            const std::uint32_t blocks = r.squares(x, y, 1),
                                colors = which.color ? group.one_color & blocks : 0,
                                depths =
                                    which.depth ? (group.one_depth | group.one_plane) & blocks : 0;
            if ((colors | depths) != 0) write_back_group(tile, x, y, colors, depths);
        }
}

struct NoColor {
    HWY_INLINE static NoPaint pixels(const TileDraw&, const Rgba&) { return {}; }
    HWY_INLINE NoColor(const TileDraw&, const Rgba&) {}
    HWY_INLINE void operator()(int, int, const LaneSet&) const {}
    HWY_INLINE void whole_blocks(UniformGroup&, int, int, std::uint32_t) const {}
};

/// A triangle's one colour.
struct OneColor {
    const std::uint64_t color;
    const FlatPaint paint;

    HWY_INLINE static FlatPaint pixels(const TileDraw& draw, const Rgba& c) { return {draw, c}; }
    HWY_INLINE OneColor(const TileDraw& draw, const Rgba& c)
        : color(std::bit_cast<std::uint64_t>(c)), paint(draw, c) {}

    HWY_INLINE void operator()(int bx, int by, const LaneSet& alive) const {
        const Tile& tile = paint.store.tile;
        const std::uint32_t mask = alive.bits();
        if (mask == all_lanes)
            return whole_blocks(tile.group(bx, by), bx, by, 1u << tile.in_group(bx, by));
        if (mask == 0) return;
        write_back_color(tile, bx, by);
        paint.write_lanes(bx, by, mask);
    }
    /// Paints blocks of a group. A uniform block stays uniform if one colour is stored or added.
    HWY_INLINE void whole_blocks(UniformGroup& group, int bx, int by, std::uint32_t blocks) const {
        const hn::CappedTag<std::uint64_t, block_pixels> d;
        std::uint32_t one = blocks;
        if (paint.store.adds) {
            add_to_pixels(bx, by, blocks & ~group.one_color);
            one &= group.one_color;
        }
        for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d))
            store_lanes(result(hn::Load(d, group.color + i)), lanes_of(d, one, i), d,
                        group.color + i);
        group.one_color = std::uint16_t(group.one_color | one);
    }

private:
    template <class Colors>
    HWY_INLINE Colors result(Colors stored) const {
        const hn::CappedTag<std::uint64_t, block_pixels> d;
        if (!paint.store.adds) return hn::Set(d, color);
        const std::uint16_t max = paint.store.max;
#if HWY_TARGET == HWY_SCALAR
        Rgba sum = std::bit_cast<Rgba>(hn::GetLane(stored));
        const Rgba own = std::bit_cast<Rgba>(color);
        for (std::size_t c = 0; c < 4; ++c)
            sum[c] = std::uint16_t(std::min(sum[c] + own[c], int(max)));
        return hn::Set(d, std::bit_cast<std::uint64_t>(sum));
#else
        const hn::Repartition<std::uint16_t, hn::CappedTag<std::uint64_t, block_pixels> > d16;
        const auto sum =
            hn::SaturatedAdd(hn::BitCast(d16, stored), hn::BitCast(d16, hn::Set(d, color)));
        return hn::BitCast(d, hn::Min(sum, hn::Set(d16, max)));
#endif
    }
    HWY_INLINE void add_to_pixels(int x, int y, std::uint32_t blocks) const {
        x -= x % group_blocks;
        y -= y % group_blocks;
        const auto add_to = [&](int i) {
            paint(x + i % group_blocks, y + i / group_blocks, AllLanes{});
        };
        if (blocks == all_lanes)
            for (int i = 0; i < group_blocks * group_blocks; ++i) add_to(i);
        else
            for (; blocks != 0; blocks &= blocks - 1) add_to(std::countr_zero(blocks));
    }
};

/// Draws a triangle's blocks.
template <class Depth, class Paint>
struct UniformDraw {
    Tile tile;
    const Depth depth;
    const Paint paint;
    LaneCounter &made, &written;

    GW_PER_BLOCK void operator()(int bx, int by, const LaneSet& lanes) const {
        made.add(lanes);
        test(bx, by, lanes);
    }
    HWY_INLINE void test(int bx, int by, const LaneSet& lanes) const {
        depth.test_lanes(bx, by, lanes, [&](const LaneSet& alive) {
            written.add(alive);
            paint(bx, by, alive);
        });
    }
    HWY_INLINE void whole_blocks(int x, int y, std::uint32_t blocks) const {
        UniformGroup& group = tile.group(x, y);
        GroupVerdicts verdicts = depth.whole_blocks(group, x, y, blocks);
        made.whole += std::uint64_t(std::popcount(blocks));
        written.whole += std::uint64_t(std::popcount(verdicts.pass));
        if (verdicts.pass != 0) paint.whole_blocks(group, x, y, verdicts.pass);
        for (; verdicts.unknown != 0; verdicts.unknown &= verdicts.unknown - 1) {
            const int i = std::countr_zero(verdicts.unknown);
            const int bx = x + i % group_blocks, by = y + i / group_blocks;
            depth.start(bx, by);
            test(bx, by, lane_set(all_lanes));
        }
    }
};

/// The one colour of each triangle of a batch that has pixels.
struct OneColors {
    Rgba of[batch_capacity];

    /// Many loads miss the first-level cache; in one loop they overlap.
    HWY_INLINE void gather(const TileDraw& draw, const Triangles& t) {
        for (std::size_t i = 0; i < t.count(); ++i)
            if (!t.empty(i)) of[i] = one_color(draw, *t.corners.primitive[i]);
    }
};

/// Triangle i of a batch over blocks that may be uniform.
template <class Size, class Paint>
struct UniformTriangle {
    const TileDraw& draw;
    const Triangles& t;
    std::size_t i;
    const BoxLanes& box;
    const Paint paint;
    LaneCounts& sum;

    template <class Compare>
    HWY_INLINE void operator()(const Compare& passes) const {
        const auto z = [&](std::size_t k) { return t.corners.z[k][i]; };
        if constexpr (!Compare::tests)
            draw_untested();
        else if (z(0) == z(1) && z(0) == z(2))
            draw_level(z(0), passes);
        else
            draw_sloping(passes);
    }

private:
    HWY_NOINLINE void draw_untested() const {
        NullWalk walk;
        draw_blocks(walk, WithoutDepth{});
    }
    template <class Compare>
    HWY_NOINLINE void draw_level(std::uint32_t z, const Compare& passes) const {
        NullWalk walk;
        draw_blocks(walk,
                    LevelDepth<Compare>{draw.tile, z, passes, draw.op->state.state.depth.mask});
    }
    template <class Compare>
    HWY_NOINLINE void draw_sloping(const Compare& passes) const {
        const DepthPlane plane = depth_of(draw, t, i);
        SlopingWalk walk(plane);
        if constexpr (std::is_same_v<Size, LargeTriangle>) walk.find_bounds(t.corners, i);
        draw_blocks(
            walk, SlopingDepth<Compare>{draw.tile, walk, passes, draw.op->state.state.depth.mask});
    }
    /// Inlined into its callers: the walk stays in registers.
    template <class Walk, class Depth>
    HWY_INLINE void draw_blocks(Walk& walk, const Depth& depth) const {
        LaneCounter made, written;
        made.clear();
        written.clear();
        Size::visit(box, t, i, walk,
                    UniformDraw<Depth, Paint>{draw.tile, depth, paint, made, written});
        LaneCounts{made, made, written}.add_to(sum);
    }
};

template <class Paint>
HWY_INLINE void draw_uniform(const TileDraw& draw, const Triangles& t, LaneCounts& sum) {
    const BoxLanes box(draw);
    OneColors colors;
    if (draw.op->state.writes_color) colors.gather(draw, t);
    with_depth_test(*draw.op, [&](const auto& passes) {
        for (std::size_t i = 0; i < t.count(); ++i) {
            if (t.empty(i)) continue;
            const Rgba& color = colors.of[i];
            const BlockRange blocks = BlockRange::of(t, i);
            if (t.is_small(i)) {
                UniformTriangle<SmallTriangle, Paint>{draw, t, i, box, {draw, color}, sum}(passes);
            } else if (blocks.is_small()) {
                // It leaves hardly any block uniform.
                write_back_range(draw.tile, touched_planes(*draw.op), blocks);
                draw_unstenciled<LargeTriangle>(draw, t, i, box, passes, Paint::pixels(draw, color),
                                                sum);
            } else {
                UniformTriangle<LargeTriangle, Paint>{draw, t, i, box, {draw, color}, sum}(passes);
            }
        }
    });
}

/// Draws a batch of triangles.
inline void draw_uniform(const TileDraw& draw, std::span<const std::uint32_t> bin,
                         OpCounts& counts) {
    Triangles t;
    LaneCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    if (draw.tile.depth_planes->size() + batch_capacity > max_depth_planes)
        write_back_tile(draw.tile, {false, true});
    draw.tile.has_uniform->color |= draw.op->state.writes_color;
    draw.tile.has_uniform->depth |= draw.op->state.state.depth.mask;
    if (draw.op->state.writes_color)
        draw_uniform<OneColor>(draw, t, lanes);
    else
        draw_uniform<NoColor>(draw, t, lanes);
    lanes.add_to(counts);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
