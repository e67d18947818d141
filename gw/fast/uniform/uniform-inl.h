// Uniform blocks: all pixels have one colour, one depth or the depths of one plane, and only this
// value is stored. clear_blocks() and the draws of draws_uniform() make such blocks. Only these,
// draw_pixels() and read_colors() use them; all other code first writes them back to the planes.
// Included once per Highway target.
#if defined(GW_FAST_UNIFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_UNIFORM_INL_H_
#undef GW_FAST_UNIFORM_INL_H_
#else
#define GW_FAST_UNIFORM_INL_H_
#endif

#include "gw/fast/simd/planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE void write_back_color(const Tile& tile, int bx, int by) {
    UniformGroup& group = tile.group(bx, by);
    const std::uint32_t i = tile.in_group(bx, by);
    if ((group.one_color >> i & 1) == 0) return;
    const D16 d;
    const Rgba color = group.color_of(i);
    ColorBlock& block = tile.color[tile.block(bx, by)];
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t k = 0; k < block_pixels; k += lanes16)
            hn::Store(hn::Set(d, color[c]), d, block.channel[c] + k);
    group.one_color = std::uint16_t(group.one_color & ~(1u << i));
}

/// Writes the depths of block (bx, by): `depth` at all pixels, or the depths of a plane.
HWY_INLINE void write_depth(const Tile& tile, std::uint32_t depth, int bx, int by) {
    const D32 d;
    for (std::size_t k = 0; k < block_pixels; k += lanes32)
        hn::Store(hn::Set(d, depth), d, tile.depth[tile.block(bx, by)].value + k);
}
HWY_NOINLINE inline void write_depth(const Tile& tile, const TilePlane& plane, int bx, int by) {
    for (std::size_t k = 0; k < block_pixels; k += lanes32)
        hn::Store(wide_plane(plane, pixels_of(bx, by, k)), D32(),
                  tile.depth[tile.block(bx, by)].value + k);
}

HWY_INLINE void write_back_depth(const Tile& tile, int bx, int by) {
    UniformGroup& group = tile.group(bx, by);
    const std::uint32_t i = tile.in_group(bx, by), bit = 1u << i;
    if (group.one_depth & bit) write_depth(tile, group.depth[i], bx, by);
    if (group.one_plane & bit) write_depth(tile, (*tile.depth_planes)[group.depth[i]], bx, by);
    group.one_depth = std::uint16_t(group.one_depth & ~bit);
    group.one_plane = std::uint16_t(group.one_plane & ~bit);
}

/// Calls visit(bx, by) for all blocks of a tile.
template <class Visit>
HWY_INLINE void for_all_blocks(const Tile& tile, const Visit& visit) {
    const int side = tile.side / block_side;
    for (int by = 0; by < side; ++by)
        for (int bx = 0; bx < side; ++bx) visit(bx, by);
}

HWY_INLINE void write_back_tile(const Tile& tile, UniformPlanes which) {
    UniformPlanes& has = *tile.has_uniform;
    if (which.color && has.color) {
        for_all_blocks(tile, [&](int bx, int by) { write_back_color(tile, bx, by); });
        has.color = false;
    }
    if (which.depth && has.depth) {
        for_all_blocks(tile, [&](int bx, int by) { write_back_depth(tile, bx, by); });
        has.depth = false;
        tile.depth_planes->clear();
    }
}

/// The result of a depth test for whole blocks of a group, a bit each. A block that fails is in
/// neither mask.
struct GroupVerdicts {
    std::uint32_t pass = 0, unknown = 0;
};

/// The blocks of a group whose depths satisfy test(depths of a vector of blocks).
template <class Test>
HWY_INLINE std::uint32_t blocks_where(const UniformGroup& group, const Test& test) {
    const D32 d;
    std::uint32_t blocks = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        blocks |= bits_of(d, test(hn::Load(d, group.depth + i)), lanes32) << i;
    return blocks;
}
HWY_INLINE void set_depths(UniformGroup& group, std::uint32_t blocks, std::uint32_t depth) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        store_lanes(hn::Set(d, depth), lanes_of(d, blocks, i), d, group.depth + i);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
