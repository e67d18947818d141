// Clearing a tile's colours and depths, and writing out what is kept of uniform blocks. docs/manual.md,
// "Pixels"; scalar twin: gw/reference/pixels.cpp. Does not clear stencils or sums.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/clear.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/kernels.h"
#include "gw/fast/uniform-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The lanes of `mask` of one block's values; whole blocks are the rule.
template <class D, class T>
HWY_INLINE void fill(D d, T (&values)[block_pixels], T value, std::uint32_t mask) {
    const auto v = hn::Set(d, value);
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
        if (mask == all_lanes)
            hn::Store(v, d, values + i);
        else
            store_lanes(v, lanes_of(d, mask, i), d, values + i);
    }
}

/// A block's colour: whole ones stay uniform.
HWY_INLINE void clear_color(const ClearBlocks& clear, std::size_t block, std::uint32_t mask) {
    UniformBlock& uniform = clear.tile.uniform[block];
    if (mask == all_lanes && clear.clears_color()) {
        uniform.color = clear.color, uniform.one_color = 1;
        return;
    }
    settle_color(uniform, clear.tile.color[block]);
    for (std::size_t c = 0; c < 4; ++c)
        if (clear.channel[c]) fill(D16(), clear.tile.color[block].channel[c], clear.color[c], mask);
}

HWY_INLINE void clear_depth(const ClearBlocks& clear, std::size_t block, std::uint32_t mask) {
    UniformBlock& uniform = clear.tile.uniform[block];
    if (mask == all_lanes) {
        uniform.depth = clear.depth, uniform.one_depth = 1;
        return;
    }
    settle_depth(uniform, clear.tile.depth[block]);
    fill(D32(), clear.tile.depth[block].value, clear.depth, mask);
}

void clear_all(const ClearBlocks& clear) {
    const BlockBox& box = clear.box;
    const bool color = clear.channel != std::array<bool, 4>{};
    clear.tile.has_uniform->color |= clear.clears_color();
    clear.tile.has_uniform->depth |= clear.clears_depth;
    if (box.whole(clear.tile) && clear.clears_color() && clear.clears_depth)
        return void(std::fill_n(clear.tile.uniform, clear.tile.blocks(),
                                UniformBlock{clear.color, clear.depth, 1, 1}));
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            const std::size_t block = clear.tile.block(bx, by);
            const std::uint32_t mask = box.mask(bx, by);
            if (color) clear_color(clear, block, mask);
            if (clear.clears_depth) clear_depth(clear, block, mask);
        }
}

void settle_all(const Tile& tile, UniformPlanes which) { settle_tile(tile, which); }

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(clear_all);
HWY_EXPORT(settle_all);

void clear_blocks(const ClearBlocks& clear) { HWY_DYNAMIC_DISPATCH(clear_all)(clear); }
void settle_blocks(const Tile& tile, UniformPlanes which) { HWY_DYNAMIC_DISPATCH(settle_all)(tile, which); }

}  // namespace gw::fast
#endif  // HWY_ONCE
