// Copies blocks between surfaces. docs/manual/samples.md, [R17.6]; scalar twin:
// gw/stages/pixels/blit.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/blit.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/tile/blit.h"
#include "gw/fast/uniform/uniform-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// A block of a tile, and the lanes of it that are copied.
struct BlockPlace {
    int bx, by;
    std::uint32_t mask;
    bool is_whole() const { return mask == all_lanes; }
};

HWY_INLINE bool has_one_color(const Tile& tile, const BlockPlace& at) {
    return (tile.group(at.bx, at.by).one_color >> Tile::in_group(at.bx, at.by) & 1) != 0;
}
HWY_INLINE Rgba one_color(const Tile& tile, const BlockPlace& at) {
    return tile.group(at.bx, at.by).color_of(Tile::in_group(at.bx, at.by));
}

template <class D, class T>
HWY_INLINE void put_lanes(D d, const T* from, std::uint32_t mask, T* to) {
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d))
        store_lanes(hn::LoadU(d, from + i), lanes_of(d, mask, i), d, to + i);
}

/// One colour for the lanes of a block.
HWY_INLINE void put_color(const Tile& to, const BlockPlace& at, const Rgba& color) {
    UniformGroup& group = to.group(at.bx, at.by);
    const std::uint32_t i = Tile::in_group(at.bx, at.by);
    if (at.is_whole()) {
        group.color[i] = std::bit_cast<std::uint64_t>(color);
        group.one_color = std::uint16_t(group.one_color | 1u << i);
        to.has_uniform->color = true;
        return;
    }
    write_back_color(to, at.bx, at.by);
    const D16 d;
    ColorBlock& block = to.color[to.block(at.bx, at.by)];
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t k = 0; k < block_pixels; k += lanes16)
            store_lanes(hn::Set(d, color[c]), lanes_of(d, at.mask, k), d, block.channel[c] + k);
}

/// The colours that `make` writes to a block, for its lanes.
template <class Make>
HWY_INLINE void put_colors(const Tile& to, const BlockPlace& at, const Make& make) {
    ColorBlock& block = to.color[to.block(at.bx, at.by)];
    if (at.is_whole()) {
        UniformGroup& group = to.group(at.bx, at.by);
        group.one_color = std::uint16_t(group.one_color & ~(1u << Tile::in_group(at.bx, at.by)));
        return make(block);
    }
    write_back_color(to, at.bx, at.by);
    ColorBlock made;
    make(made);
    for (std::size_t c = 0; c < 4; ++c)
        put_lanes(D16(), made.channel[c], at.mask, block.channel[c]);
}

HWY_INLINE void copy_color(const Tile& from, const Tile& to, const BlockPlace& at) {
    if (has_one_color(from, at)) return put_color(to, at, one_color(from, at));
    const ColorBlock& block = from.color[from.block(at.bx, at.by)];
    put_colors(to, at, [&](ColorBlock& out) { out = block; });
}

/// The mean of a channel of all samples, to nearest.
HWY_INLINE void mean_channel(std::span<const Tile> samples, const BlockPlace& at, std::size_t c,
                             std::uint16_t* out) {
    const D32 d;
    const int log2_count = std::countr_zero(samples.size());
    for (std::size_t k = 0; k < block_pixels; k += lanes32) {
        auto sum = hn::Set(d, std::uint32_t(samples.size() / 2));
        for (const Tile& tile : samples)
            sum = hn::Add(sum,
                          has_one_color(tile, at)
                              ? hn::Set(d, std::uint32_t{one_color(tile, at)[c]})
                              : load_channel(tile.color[tile.block(at.bx, at.by)].channel[c] + k));
        store16(hn::ShiftRightSame(sum, log2_count), out + k);
    }
}

HWY_INLINE void copy_mean(std::span<const Tile> samples, const Tile& to, const BlockPlace& at) {
    const Rgba first = one_color(samples[0], at);
    bool is_one = true;
    for (const Tile& tile : samples)
        is_one = is_one && has_one_color(tile, at) && one_color(tile, at) == first;
    if (is_one) return put_color(to, at, first);
    put_colors(to, at, [&](ColorBlock& out) {
        for (std::size_t c = 0; c < 4; ++c) mean_channel(samples, at, c, out.channel[c]);
    });
}

HWY_INLINE void copy_depth(const Tile& from, const Tile& to, const BlockPlace& at) {
    const UniformGroup& source = from.group(at.bx, at.by);
    const std::uint32_t i = Tile::in_group(at.bx, at.by), bit = 1u << i;
    UniformGroup& target = to.group(at.bx, at.by);
    if ((source.one_depth & bit) != 0 && at.is_whole()) {
        target.depth[i] = source.depth[i];
        target.one_depth = std::uint16_t(target.one_depth | bit);
        target.one_plane = std::uint16_t(target.one_plane & ~bit);
        to.has_uniform->depth = true;
        return;
    }
    write_back_depth(from, at.bx, at.by);
    write_back_depth(to, at.bx, at.by);
    put_lanes(D32(), from.depth[from.block(at.bx, at.by)].value, at.mask,
              to.depth[to.block(at.bx, at.by)].value);
}

HWY_INLINE void copy_stencil(const Tile& from, const Tile& to, const BlockPlace& at) {
    put_lanes(D8(), from.stencil[from.block(at.bx, at.by)].value, at.mask,
              to.stencil[to.block(at.bx, at.by)].value);
}

/// Copies a block of each sample.
template <class CopyBlock>
HWY_INLINE void copy_each(const BlitBlocks& blit, const CopyBlock& copy) {
    for (std::size_t k = 0; k < blit.to.size(); ++k)
        copy(blit.from.size() == 1 ? blit.from[0] : blit.from[k], blit.to[k]);
}

HWY_INLINE void blit_block(const BlitBlocks& blit, const BlockPlace& at) {
    if (blit.planes & mask_of(Plane::Color)) {
        if (blit.from.size() > blit.to.size())
            copy_mean(blit.from, blit.to[0], at);
        else
            copy_each(blit, [&](const Tile& a, const Tile& b) { copy_color(a, b, at); });
    }
    if (blit.planes & mask_of(Plane::Depth))
        copy_each(blit, [&](const Tile& a, const Tile& b) { copy_depth(a, b, at); });
    if (blit.planes & mask_of(Plane::Stencil))
        copy_each(blit, [&](const Tile& a, const Tile& b) { copy_stencil(a, b, at); });
}

void blit_all(const BlitBlocks& blit) {
    const BlockBox& box = blit.box;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx)
            blit_block(blit, {bx, by, box.mask(bx, by)});
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(blit_all);

void blit_blocks(const BlitBlocks& blit) { HWY_DYNAMIC_DISPATCH(blit_all)(blit); }

}  // namespace gw::fast
#endif  // HWY_ONCE
