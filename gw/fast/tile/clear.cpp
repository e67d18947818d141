// Clears a tile, group by group if possible. docs/manual.md, "Pixels"; scalar twin:
// gw/reference/pixels.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/clear.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/tile/clear.h"
#include "gw/fast/uniform/uniform-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Sets the lanes of `mask` in one block. Most blocks have all lanes in the mask.
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

/// Sets these bits of the lanes of `mask` in one channel.
HWY_INLINE void fill_bits(std::uint16_t (&values)[block_pixels], std::uint16_t value,
                          std::uint16_t bits, std::uint32_t mask) {
    const D16 d;
    const auto kept = hn::Set(d, std::uint16_t(~bits)),
               set = hn::Set(d, std::uint16_t(value & bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        const auto v = hn::Or(hn::And(hn::Load(d, values + i), kept), set);
        store_lanes(v, lanes_of(d, mask, i), d, values + i);
    }
}

/// Sets a block's colour. A block that is set wholly becomes uniform.
HWY_INLINE void clear_color(const ClearBlocks& clear, int bx, int by, std::uint32_t mask) {
    UniformGroup& group = clear.tile.group(bx, by);
    const std::uint32_t i = clear.tile.in_group(bx, by);
    if (mask == all_lanes && clear.clears_color) {
        group.color[i] = std::bit_cast<std::uint64_t>(clear.color);
        group.one_color = std::uint16_t(group.one_color | 1u << i);
        return;
    }
    write_back_color(clear.tile, bx, by);
    ColorBlock& block = clear.tile.color[clear.tile.block(bx, by)];
    for (std::size_t c = 0; c < 4; ++c)
        fill_bits(block.channel[c], clear.color[c], clear.written_bits[c], mask);
}

HWY_INLINE void clear_depth(const ClearBlocks& clear, int bx, int by, std::uint32_t mask) {
    UniformGroup& group = clear.tile.group(bx, by);
    const std::uint32_t i = clear.tile.in_group(bx, by);
    if (mask == all_lanes) {
        group.depth[i] = clear.depth;
        group.one_depth = std::uint16_t(group.one_depth | 1u << i);
        group.one_plane = std::uint16_t(group.one_plane & ~(1u << i));
        return;
    }
    write_back_depth(clear.tile, bx, by);
    fill(D32(), clear.tile.depth[clear.tile.block(bx, by)].value, clear.depth, mask);
}

/// Sets the colours and depths of whole groups, if the box has no others.
HWY_INLINE void clear_groups(const ClearBlocks& clear) {
    constexpr int side = group_blocks * block_side;
    for (int y = clear.box.y0; y < clear.box.y1; y += side)
        for (int x = clear.box.x0; x < clear.box.x1; x += side) {
            UniformGroup& group = clear.tile.group(x / block_side, y / block_side);
            if (clear.clears_color) {
                std::fill(std::begin(group.color), std::end(group.color),
                          std::bit_cast<std::uint64_t>(clear.color));
                group.one_color = all_lanes;
            }
            if (!clear.clears_depth) continue;
            std::fill(std::begin(group.depth), std::end(group.depth), clear.depth);
            group.one_depth = all_lanes;
            group.one_plane = 0;
        }
}

void clear_all(const ClearBlocks& clear) {
    const BlockBox& box = clear.box;
    const bool color = clear.touches_color();
    clear.tile.has_uniform->color |= clear.clears_color;
    clear.tile.has_uniform->depth |= clear.clears_depth;
    if (box.whole(clear.tile) && clear.clears_depth) clear.tile.depth_planes->clear();
    const bool groups = (box.x0 | box.y0 | box.x1 | box.y1) % (group_blocks * block_side) == 0;
    if (groups && color == clear.clears_color) return clear_groups(clear);
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            const std::uint32_t mask = box.mask(bx, by);
            if (color) clear_color(clear, bx, by, mask);
            if (clear.clears_depth) clear_depth(clear, bx, by, mask);
        }
}

void write_back_all(const Tile& tile, UniformPlanes which) { write_back_tile(tile, which); }

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(clear_all);
HWY_EXPORT(write_back_all);

void clear_blocks(const ClearBlocks& clear) { HWY_DYNAMIC_DISPATCH(clear_all)(clear); }
void write_back_blocks(const Tile& tile, UniformPlanes which) {
    HWY_DYNAMIC_DISPATCH(write_back_all)(tile, which);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
