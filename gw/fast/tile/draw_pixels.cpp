// Rectangles of pixels as fragments, a block at a time. docs/manual/pixels.md, "Drawn pixels"; scalar
// twin: gw/reference/pixels.cpp. Does not write stencil values: gw/fast/tile/tile_run.cpp does.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/draw_pixels.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/fragments/fragments-inl.h"
#include "gw/fast/tile/draw.h"
#include "gw/fast/tile/draw_pixels.h"
#include "gw/fast/uniform/uniform-inl.h"
#include "gw/stages/pixels/draw_pixels.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

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
};

/// The colours of a block's lanes as they are in the rectangle. Lanes beside it have those of the
/// pixels next to them.
HWY_INLINE void load_colors(const PlacedPixels& placed, int x, int y, ColorBlock& to) {
    const Rect& box = placed.box();
    const auto column = [&](int i) {
        return *placed.columns_from(std::clamp(x + i, box.x, box.x + box.width - 1));
    };
    const int columns[block_side] = {column(0), column(1), column(2), column(3)};
    const bool adjacent = columns[1] - columns[0] == 1 && columns[2] - columns[1] == 1 &&
                          columns[3] - columns[2] == 1;
    alignas(64) Rgba pixels[block_pixels];
    for (int row = 0; row < block_side; ++row) {
        const Rgba* const from =
            placed.colors_of_row(std::clamp(y + row, box.y, box.y + box.height - 1));
        Rgba* const at = pixels + row * block_side;
        if (adjacent)
            std::memcpy(at, from + columns[0], sizeof(Rgba) * block_side);
        else
            for (int i = 0; i < block_side; ++i) at[i] = from[columns[i]];
    }
    const D16 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        hn::Vec<D16> r, g, b, a;
        hn::LoadInterleaved4(d, pixels[i].data(), r, g, b, a);
        hn::Store(r, d, to.channel[0] + i);
        hn::Store(g, d, to.channel[1] + i);
        hn::Store(b, d, to.channel[2] + i);
        hn::Store(a, d, to.channel[3] + i);
    }
}

/// Whether all fragments pass and do no more than store their colours.
bool only_stores_colors(const Resolved& r) {
    const State& s = r.state;
    return r.samples == 1 && s.alpha.func == AlphaFunc::Always && ignores_stencil(r.front) &&
           s.depth.func == DepthFunc::Always && !s.depth.mask && r.writes_whole_color &&
           !s.blend.enable && !s.logic_op.enable && !draws_to_both(s);
}

struct PixelsInTile {
    const PixelsDraw& draw;
    const PlacedPixels& placed = *draw.placed;
    const Resolved& state = *draw.state;
    const Tile& tile = draw.tile;
    const bool has_plain_colors = placed.has_plain_colors(),
               only_stores = only_stores_colors(state),
               depth = state.state.depth.func != DepthFunc::Always || state.state.depth.mask;
    BlockOfPixels block{};

    HWY_INLINE void draw_block(int bx, int by, std::uint32_t mask) {
        const int x = tile.x + bx * block_side, y = tile.y + by * block_side;
        if (has_plain_colors && only_stores && mask == all_lanes) return store_block(bx, by, x, y);
        if (has_plain_colors)
            load_colors(placed, x, y, block.color);
        else
            mask = block.take(placed, x, y, mask);
        if (mask == 0) return;
        if (state.writes_color) write_back_color(tile, bx, by);
        if (depth) write_back_depth(tile, bx, by);
        if (state.samples > 1)
            return process_fragments({&state, tile.block(bx, by), mask, true, draw.sample},
                                     block.color, block.depth, tile, *draw.counts);
        run_fragments(state, true, block.depth, tile, tile.block(bx, by), mask, *draw.counts,
                      [&]() -> const ColorBlock& { return block.color; });
    }
    HWY_INLINE void store_block(int bx, int by, int x, int y) const {
        load_colors(placed, x, y, tile.color[tile.block(bx, by)]);
        UniformGroup& group = tile.group(bx, by);
        group.one_color = std::uint16_t(group.one_color & ~(1u << tile.in_group(bx, by)));
        draw.counts->fragments += block_pixels;
        draw.counts->written += block_pixels;
    }
};

void draw_all_pixels(const PixelsDraw& draw) {
    PixelsInTile pixels{draw};
    if (pixels.has_plain_colors)
        std::fill_n(pixels.block.depth.value, block_pixels, draw.placed->depth(0));
    const BlockBox& box = draw.box;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx)
            pixels.draw_block(bx, by, box.mask(bx, by));
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(draw_all_pixels);

void draw_pixels(const PixelsDraw& draw) { HWY_DYNAMIC_DISPATCH(draw_all_pixels)(draw); }

}  // namespace gw::fast
#endif  // HWY_ONCE
