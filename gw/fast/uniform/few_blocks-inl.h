// Triangles on a few blocks, some of which may be uniform. A uniform block is read as pixels of its
// one value, and its own pixels are stored with those that change. Larger triangles:
// gw/fast/uniform/uniform_draw-inl.h. Included once per Highway target.
#if defined(GW_FAST_FEW_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_FEW_BLOCKS_INL_H_
#undef GW_FAST_FEW_BLOCKS_INL_H_
#else
#define GW_FAST_FEW_BLOCKS_INL_H_
#endif

#include "gw/fast/fragments/depth-inl.h"
#include "gw/fast/fragments/flat_paint-inl.h"
#include "gw/fast/raster/covered_blocks-inl.h"
#include "gw/fast/uniform/uniform-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The depths of a triangle that has one depth.
struct LevelWalk {
    std::uint32_t z;
    HWY_INLINE void start(int, int) const {}
    HWY_INLINE V32 at(std::size_t) const { return hn::Set(D32(), z); }
};

/// A block of a tile, and its place among the uniform blocks.
struct BlockPlace {
    std::size_t block;
    UniformGroup& group;
    std::uint32_t in_group;

    HWY_INLINE BlockPlace(const Tile& tile, int bx, int by)
        : block(tile.block(bx, by)), group(tile.group(bx, by)), in_group(tile.in_group(bx, by)) {}
    HWY_INLINE bool is_in(std::uint16_t blocks) const { return (blocks >> in_group & 1) != 0; }
    HWY_INLINE void take_from(std::uint16_t& blocks) const {
        blocks = std::uint16_t(blocks & ~(1u << in_group));
    }
};

/// Stores one colour in some lanes, or adds it.
struct FewColor {
    const FlatPaint paint;
    FilledBlocks& filled;

    HWY_INLINE FewColor(const TileDraw& draw, const Rgba& c)
        : paint(draw, c), filled(draw.scratch->filled) {}
    HWY_INLINE void operator()(const BlockPlace& at, std::uint32_t alive) const {
        ColorBlock& block = paint.store.tile.color[at.block];
        const ColorBlock& stored =
            at.is_in(at.group.one_color) ? filled.of_color(at.group.color_of(at.in_group)) : block;
        paint.write_lanes(stored, block, alive);
        at.take_from(at.group.one_color);
    }
};
struct FewUncolored {
    HWY_INLINE FewUncolored(const TileDraw&, const Rgba&) {}
    HWY_INLINE void operator()(const BlockPlace&, std::uint32_t) const {}
};

/// Draws one triangle's blocks. The tile is a copy, which stays in registers.
template <class Compare, class Walk, class Paint>
struct FewBlocks {
    const Tile tile;
    FilledBlocks& filled;
    const Compare passes;
    Walk& walk;
    const Paint& paint;
    const bool update;
    std::uint64_t made = 0, written = 0;

    HWY_INLINE void operator()(int bx, int by, std::uint32_t lanes) {
        const BlockPlace at(tile, bx, by);
        made += std::uint64_t(std::popcount(lanes));
        if constexpr (Compare::tests) lanes = test(at, bx, by, lanes);
        if (lanes == 0) return;
        written += std::uint64_t(std::popcount(lanes));
        paint(at, lanes);
    }
    HWY_INLINE void add_to(OpCounts& counts) const {
        counts.fragments += made;
        counts.depth_killed += made - written;
        counts.written += written;
    }

private:
    /// The lanes that pass.
    HWY_INLINE std::uint32_t test(const BlockPlace& at, int bx, int by, std::uint32_t lanes) const {
        const D32 d;
        if (at.is_in(at.group.one_plane)) write_back_depth(tile, bx, by);
        DepthBlock& block = tile.depth[at.block];
        const DepthBlock& stored =
            at.is_in(at.group.one_depth) ? filled.of_depth(at.group.depth[at.in_group]) : block;
        walk.start(bx, by);
        std::uint32_t alive = 0;
        for (std::size_t k = 0; k < parts; ++k) {
            const auto z = walk.at(k), own = hn::Load(d, stored.value + k * lanes32);
            const M32 pass = hn::And(passes(z, own), lanes_of(d, lanes, k * lanes32));
            alive |= bits_of(d, pass, lanes32) << (k * lanes32);
            if (update) hn::Store(hn::IfThenElse(pass, z, own), d, block.value + k * lanes32);
        }
        if (update) at.take_from(at.group.one_depth);
        return alive;
    }
};

/// Triangle i of a batch, and its one colour.
template <class Blocks, class Paint>
struct FewBlocksTriangle {
    const TileDraw& draw;
    const Triangles& t;
    std::size_t i;
    const Blocks& covered;
    const Rgba& color;
    OpCounts& counts;

    template <class Compare>
    HWY_INLINE void operator()(const Compare& passes) const {
        const auto z = [&](std::size_t k) { return t.corners.z[k][i]; };
        if (!Compare::tests || (z(0) == z(1) && z(0) == z(2)))
            draw_level(passes, z(0));
        else
            draw_sloping(passes);
    }

private:
    template <class Compare>
    HWY_NOINLINE void draw_level(const Compare& passes, std::uint32_t z) const {
        LevelWalk walk{z};
        draw_with(passes, walk);
    }
    template <class Compare>
    HWY_NOINLINE void draw_sloping(const Compare& passes) const {
        WidePlaneWalk walk;
        walk.aim(depth_of(draw, t, i).plane);
        draw_with(passes, walk);
    }
    template <class Compare, class Walk>
    HWY_INLINE void draw_with(const Compare& passes, Walk& walk) const {
        const Paint paint(draw, color);
        FewBlocks<Compare, Walk, Paint> blocks{
            draw.tile, draw.scratch->filled, passes, walk, paint, draw.op->state.state.depth.mask};
        covered.visit(blocks);
        blocks.add_to(counts);
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
