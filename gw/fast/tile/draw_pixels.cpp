// Rectangles of pixels as fragments, a block at a time. docs/manual/pixels.md, "Drawn pixels"; scalar
// twin: gw/reference/pixels.cpp. Does not write stencil values: gw/fast/tile/tile_run.cpp does.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/draw_pixels.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/fragments/fragments-inl.h"
#include "gw/fast/tile/draw_pixels.h"
#include "gw/fast/uniform/uniform-inl.h"
#include "gw/stages/pixels/draw_pixels.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The fragments of one block.
struct BlockOfPixels {
    DepthBlock depth;
    ColorBlock color;

    /// The lanes of `mask` one by one; those that have a pixel.
    HWY_INLINE std::uint32_t take(const PlacedPixels& placed, int x, int y, std::uint32_t mask) {
        std::uint32_t drawn = 0;
        for (; mask != 0; mask &= mask - 1) {
            const int lane = std::countr_zero(mask);
            const std::optional<std::size_t> pixel =
                placed.source_of(x + lane % block_side, y + lane / block_side);
            if (!pixel) continue;
            drawn |= 1u << lane;
            const Rgba from = placed.color(*pixel);
            for (std::size_t c = 0; c < 4; ++c) color.channel[c][lane] = from[c];
            depth.value[lane] = placed.depth(*pixel);
        }
        return drawn;
    }
    /// The colours of all lanes, as they are in the rectangle.
    HWY_INLINE void take_colors(const PlacedPixels& placed, int x, int y) {
        alignas(64) Rgba pixels[block_pixels];
        for (int row = 0; row < block_side; ++row) {
            const Rgba* const from = placed.colors_of_row(y + row);
            const int* const column = placed.columns_from(x);
            for (int i = 0; i < block_side; ++i) pixels[row * block_side + i] = from[column[i]];
        }
        const D16 d;
        for (std::size_t i = 0; i < block_pixels; i += lanes16) {
            hn::Vec<D16> r, g, b, a;
            hn::LoadInterleaved4(d, pixels[i].data(), r, g, b, a);
            hn::Store(r, d, color.channel[0] + i);
            hn::Store(g, d, color.channel[1] + i);
            hn::Store(b, d, color.channel[2] + i);
            hn::Store(a, d, color.channel[3] + i);
        }
    }
};

void draw_all_pixels(const PixelsDraw& draw) {
    const PlacedPixels& placed = *draw.placed;
    const Resolved& state = *draw.state;
    const Tile& tile = draw.tile;
    const bool as_they_are = placed.has_plain_colors(),
               depth = state.state.depth.func != DepthFunc::Always || state.state.depth.mask;
    BlockOfPixels block{};
    if (as_they_are) std::fill_n(block.depth.value, block_pixels, placed.depth(0));
    const BlockBox& box = draw.box;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            const int x = tile.x + bx * block_side, y = tile.y + by * block_side;
            std::uint32_t mask = box.mask(bx, by);
            if (as_they_are && mask == all_lanes)
                block.take_colors(placed, x, y);
            else
                mask = block.take(placed, x, y, mask);
            if (mask == 0) continue;
            if (state.writes_color) write_back_color(tile, bx, by);
            if (depth) write_back_depth(tile, bx, by);
            run_fragments(state, true, block.depth, tile, tile.block(bx, by), mask, *draw.counts,
                          [&]() -> const ColorBlock& { return block.color; });
        }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(draw_all_pixels);

void draw_pixels(const PixelsDraw& draw) { HWY_DYNAMIC_DISPATCH(draw_all_pixels)(draw); }

}  // namespace gw::fast
#endif  // HWY_ONCE
