// Reading the colour plane back: a block's four channels become pixels side by side.
// docs/manual.md, "Pixels and copies"; scalar twin: gw/reference/pixels.cpp. Does not know passes or counts.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/read.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/kernels.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D16 = hn::CappedTag<std::uint16_t, block_pixels>;

/// The block's pixels, lane by lane.
HWY_INLINE void interleave(const ColorBlock& block, Rgba* pixels) {
    const D16 d;
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
        const auto channel = [&](std::size_t c) { return hn::Load(d, block.channel[c] + i); };
        hn::StoreInterleaved4(channel(0), channel(1), channel(2), channel(3), d, pixels[i].data());
    }
}

/// Writes the lanes of `mask` of one block, whose lowest pixel is (x, y) of the rectangle.
HWY_INLINE void write_block(const ReadColors& read, const Rgba* pixels, int x, int y, std::uint32_t mask) {
    const auto at = [&](int column, int row) {
        return read.out + std::ptrdiff_t(y + row) * read.rect.width + x + column;
    };
    if (mask == 0xFFFF) {
        for (int row = 0; row < block_side; ++row)
            std::copy_n(pixels + row * block_side, block_side, at(0, row));
        return;
    }
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        *at(lane % block_side, lane / block_side) = pixels[lane];
    }
}

void read_all(const ReadColors& read) {
    const Tile& tile = read.tile;
    const BlockBox& box = read.box;
    alignas(64) Rgba pixels[block_pixels];
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            interleave(tile.color[tile.block(bx, by)], pixels);
            write_block(read, pixels, tile.x + bx * block_side - read.rect.x,
                        tile.y + by * block_side - read.rect.y, box.mask(bx, by));
        }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(read_all);

void read_colors(const ReadColors& read) { HWY_DYNAMIC_DISPATCH(read_all)(read); }

}  // namespace gw::fast
#endif  // HWY_ONCE
