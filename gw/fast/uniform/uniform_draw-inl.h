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
#include "gw/fast/uniform/few_blocks-inl.h"
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

struct NoColor {
    using Few = FewUncolored;
    HWY_INLINE NoColor(const TileDraw&, const Rgba&) {}
    HWY_INLINE void operator()(int, int, const LaneSet&) const {}
    HWY_INLINE void whole_blocks(UniformGroup&, int, int, std::uint32_t) const {}
};

/// A triangle's one colour.
struct OneColor {
    using Few = FewColor;
    const std::uint64_t color;
    const FlatPaint paint;

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

/// Triangle i of a batch over blocks that may be uniform.
template <class Paint>
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
        walk.find_bounds(t.corners, i);
        draw_blocks(
            walk, SlopingDepth<Compare>{draw.tile, walk, passes, draw.op->state.state.depth.mask});
    }
    /// Inlined into its callers: the walk stays in registers.
    template <class Walk, class Depth>
    HWY_INLINE void draw_blocks(Walk& walk, const Depth& depth) const {
        LaneCounter made, written;
        made.clear();
        written.clear();
        LargeTriangle::visit(box, t, i, walk,
                             UniformDraw<Depth, Paint>{draw.tile, depth, paint, made, written});
        LaneCounts{made, made, written}.add_to(sum);
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

/// A batch's triangles, the neighbours of one quad together if they have one colour and one depth.
template <class Compare, class Paint>
struct UniformBatch {
    const TileDraw& draw;
    const Triangles& t;
    const BoxLanes box;
    const OneColors& colors;
    const Compare passes;
    LaneCounts& sum;
    OpCounts& counts;

    HWY_INLINE void run() const {
        for (std::size_t i = 0; i < t.count(); ++i) {
            if (t.empty(i)) continue;
            const BlockRange range = BlockRange::of(t, i);
            if (!range.is_small())
                UniformTriangle<Paint>{draw, t, i, box, {draw, colors.of[i]}, sum}(passes);
            else if (draw_two(i, range))
                i += 1;
            else if (t.is_small(i))
                draw_few(i, SmallBlocks(box, t, i));
            else
                draw_few(i, CoveredBlocks(box, t, i, range));
        }
    }

private:
    template <class Blocks>
    HWY_INLINE void draw_few(std::size_t i, const Blocks& blocks) const {
        using Few = FewBlocksTriangle<Blocks, typename Paint::Few>;
        Few{draw, t, i, blocks, colors.of[i], counts}(passes);
    }
    /// Draws triangles i and i + 1 if they can be drawn as one: no pixel may be in both.
    HWY_INLINE bool draw_two(std::size_t i, const BlockRange& range) const {
        if (i + 1 == t.count() || !are_alike(i) || t.empty(i + 1)) return false;
        const BlockRange both = range.with(BlockRange::of(t, i + 1));
        if (!both.is_small() || !has_short_edges(t.edges(i)) || !has_short_edges(t.edges(i + 1)))
            return false;
        const CoveredBlocks blocks = CoveredBlocks::of_two(box, t, i, both);
        if (!blocks.overlap()) draw_few(i, blocks);
        return !blocks.overlap();
    }
    /// Whether triangles i and i + 1 have the same one depth and the same colour.
    HWY_INLINE bool are_alike(std::size_t i) const {
        if constexpr (Compare::tests) {
            const auto& z = t.corners.z;
            if (z[0][i] != z[1][i] || z[0][i] != z[2][i] || z[0][i] != z[0][i + 1] ||
                z[0][i] != z[1][i + 1] || z[0][i] != z[2][i + 1])
                return false;
        }
        return !draw.op->state.writes_color || colors.of[i] == colors.of[i + 1];
    }
};

template <class Paint>
HWY_INLINE void draw_uniform(const TileDraw& draw, const Triangles& t, LaneCounts& sum,
                             OpCounts& counts) {
    OneColors colors;
    if (draw.op->state.writes_color) colors.gather(draw, t);
    with_depth_test(*draw.op, [&]<class Compare>(const Compare& passes) {
        UniformBatch<Compare, Paint>{draw, t, BoxLanes(draw), colors, passes, sum, counts}.run();
    });
}

/// Draws a batch of triangles, or returns false as draw_simple(). GCC takes the loops under the
/// eight depth tests for seldom run, and compiles them for size, if not told.
[[gnu::hot]] inline bool draw_uniform(const TileDraw& draw, std::span<const std::uint32_t> bin,
                                      OpCounts& counts) {
    Triangles t;
    LaneCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    if (!includes_offsets(draw, t)) return false;
    if (draw.tile.depth_planes->size() + batch_capacity > max_depth_planes)
        write_back_tile(draw.tile, {false, true});
    draw.tile.has_uniform->color |= draw.op->state.writes_color;
    draw.tile.has_uniform->depth |= draw.op->state.state.depth.mask;
    if (draw.op->state.writes_color)
        draw_uniform<OneColor>(draw, t, lanes, counts);
    else
        draw_uniform<NoColor>(draw, t, lanes, counts);
    lanes.add_to(counts);
    return true;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
