// Reading the colour plane back: a block's four channels become pixels side by side.
// docs/manual.md, "Pixels"; scalar twin: gw/reference/pixels.cpp. Does not know passes or counts.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/read.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/kernels.h"
#include "gw/fast/lanes-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The block's pixels, lane by lane.
HWY_INLINE void interleave(const ColorBlock& block, Rgba* pixels) {
    const D16 d;
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
        const auto channel = [&](std::size_t c) { return hn::Load(d, block.channel[c] + i); };
        hn::StoreInterleaved4(channel(0), channel(1), channel(2), channel(3), d, pixels[i].data());
    }
}

#if HWY_MAX_BYTES >= 32

/// A block's four rows, each in one vector.
HWY_INLINE void store_rows(const ColorBlock& block, Rgba* lowest, std::ptrdiff_t width) {
    const D16 d;
    const hn::Repartition<std::uint32_t, D16> pairs;
    const auto channel = [&](std::size_t c) { return hn::Load(d, block.channel[c]); };
    const auto store = [&](int row, auto v) { hn::StoreU(hn::BitCast(d, v), d, lowest[row * width].data()); };
    const auto low = [&](std::size_t c) {
        return hn::BitCast(pairs, hn::InterleaveLower(d, channel(c), channel(c + 1)));
    };
    const auto high = [&](std::size_t c) {
        return hn::BitCast(pairs, hn::InterleaveUpper(d, channel(c), channel(c + 1)));
    };
    // Rows 0 and 2, then 1 and 3: vectors are interleaved by halves.
    const auto two_rows = [&](int row, auto rg, auto ba) {
        const auto left = hn::InterleaveLower(pairs, rg, ba), right = hn::InterleaveUpper(pairs, rg, ba);
        store(row, hn::ConcatLowerLower(pairs, right, left));
        store(row + 2, hn::ConcatUpperUpper(pairs, right, left));
    };
    two_rows(0, low(0), low(2));
    two_rows(1, high(0), high(2));
}

#else

HWY_INLINE void store_rows(const ColorBlock& block, Rgba* lowest, std::ptrdiff_t width) {
    alignas(64) Rgba pixels[block_pixels];
    interleave(block, pixels);
    for (int row = 0; row < block_side; ++row)
        std::copy_n(pixels + row * block_side, block_side, lowest + row * width);
}

#endif  // HWY_MAX_BYTES >= 32

/// The lanes of `mask`.
HWY_INLINE void store_some(const ColorBlock& block, std::uint32_t mask, Rgba* lowest, std::ptrdiff_t width) {
    alignas(64) Rgba pixels[block_pixels];
    interleave(block, pixels);
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        lowest[lane / block_side * width + lane % block_side] = pixels[lane];
    }
}

/// A block's colours as words, those of `mask`.
HWY_INLINE void store_words(const ColorBlock& block, std::uint32_t mask, std::uint32_t* lowest,
                            std::ptrdiff_t width) {
    const D32 d;
    alignas(64) std::uint32_t words[block_pixels];
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto channel = [&](std::size_t c) {
            return hn::PromoteTo(d, hn::Load(Half16(), block.channel[c] + i));
        };
        const auto rg = hn::Or(channel(0), hn::ShiftLeft<8>(channel(1))),
                   ba = hn::Or(channel(2), hn::ShiftLeft<8>(channel(3)));
        hn::Store(hn::Or(rg, hn::ShiftLeft<16>(ba)), d, words + i);
    }
    if (mask == all_lanes)
        for (int row = 0; row < block_side; ++row)
            std::copy_n(words + row * block_side, block_side, lowest + row * width);
    else
        for (; mask != 0; mask &= mask - 1) {
            const int lane = std::countr_zero(mask);
            lowest[lane / block_side * width + lane % block_side] = words[lane];
        }
}

/// A block's colours, those of `mask`.
HWY_INLINE void store_colors(const ColorBlock& block, std::uint32_t mask, Rgba* lowest,
                             std::ptrdiff_t width) {
    if (mask == all_lanes)
        store_rows(block, lowest, width);
    else
        store_some(block, mask, lowest, width);
}

void read_all(const ReadColors& read) {
    const Tile& tile = read.tile;
    const BlockBox& box = read.box;
    const std::ptrdiff_t width = read.rect.width;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            const ColorBlock& block = tile.color[tile.block(bx, by)];
            const int x = tile.x + bx * block_side - read.rect.x, y = tile.y + by * block_side - read.rect.y;
            const std::ptrdiff_t lowest = y * width + x;
            const std::uint32_t mask = box.mask(bx, by);
            if (read.packed)
                store_words(block, mask, read.packed + lowest, width);
            else
                store_colors(block, mask, read.out + lowest, width);
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
