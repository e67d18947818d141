// Reading the colour plane back: a block's four channels become pixels side by side.
// docs/manual.md, "Pixels"; scalar twin: gw/reference/pixels.cpp. Does not know passes or counts.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/read.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/kernels.h"
#include "gw/fast/lanes-inl.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Four rows of a tile's pixels, blocks side by side: the window's rows are written whole.
template <class Pixel>
struct Strip {
    static constexpr std::ptrdiff_t width = 64;
    alignas(64) Pixel pixels[block_side * width];

    HWY_INLINE Pixel* block(int bx) { return pixels + bx * block_side; }
    HWY_INLINE void put(int bx, const Pixel& value) {
        for (int row = 0; row < block_side; ++row) std::fill_n(block(bx) + row * width, block_side, value);
    }
};

#if HWY_MAX_BYTES >= 32

/// A block's four rows, each in one vector.
HWY_INLINE void put_block(const ColorBlock& block, Rgba* lowest, std::ptrdiff_t width) {
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

HWY_INLINE void put_block(const ColorBlock& block, Rgba* lowest, std::ptrdiff_t width) {
    const D16 d;
    alignas(64) Rgba pixels[block_pixels];
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
        const auto channel = [&](std::size_t c) { return hn::Load(d, block.channel[c] + i); };
        hn::StoreInterleaved4(channel(0), channel(1), channel(2), channel(3), d, pixels[i].data());
    }
    for (int row = 0; row < block_side; ++row)
        std::copy_n(pixels + row * block_side, block_side, lowest + row * width);
}

#endif  // HWY_MAX_BYTES >= 32

/// A block's colours as words.
HWY_INLINE void put_block(const ColorBlock& block, std::uint32_t* lowest, std::ptrdiff_t width) {
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
    for (int row = 0; row < block_side; ++row)
        std::copy_n(words + row * block_side, block_side, lowest + row * width);
}

HWY_INLINE Rgba pixel_of(const Rgba& color, const Rgba*) { return color; }
HWY_INLINE std::uint32_t pixel_of(const Rgba& color, const std::uint32_t*) { return packed(color); }

/// Where the box's pixels go: a row of `width` after the other.
template <class Pixel>
struct Target {
    const ReadColors& read;
    Pixel* out;

    HWY_INLINE Pixel* row(int y) const {
        const Rect& rect = read.rect;
        return out + std::ptrdiff_t(read.tile.y + y - rect.y) * rect.width +
               (read.tile.x + read.box.x0 - rect.x);
    }
    HWY_INLINE std::size_t width() const { return std::size_t(read.box.x1 - read.box.x0); }
    /// Rows of the next strip, on their way to the cache while this one is made.
    HWY_INLINE void prefetch(int first, int end) const {
        for (int y = first; y < std::min(end, read.box.y1); ++y)
            for (std::size_t x = 0; x < width(); x += 64 / sizeof(Pixel)) hwy::Prefetch(row(y) + x);
    }
};

template <class Pixel>
HWY_INLINE void read_rows(const ReadColors& read, Pixel* out) {
    const BlockBox& box = read.box;
    const Target<Pixel> target{read, out};
    Strip<Pixel> strip;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by) {
        const int end = (by + 1) * block_side;
        target.prefetch(end, end + block_side);
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            const std::size_t block = read.tile.block(bx, by);
            const UniformBlock& uniform = read.tile.uniform[block];
            if (uniform.one_color)
                strip.put(bx, pixel_of(uniform.color, out));
            else
                put_block(read.tile.color[block], strip.block(bx), strip.width);
        }
        for (int y = std::max(box.y0, by * block_side); y < std::min(box.y1, end); ++y)
            std::copy_n(strip.pixels + y % block_side * strip.width + box.x0, target.width(), target.row(y));
    }
}

void read_all(const ReadColors& read) {
    read.packed ? read_rows(read, read.packed) : read_rows(read, read.out);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(read_all);

void read_colors(const ReadColors& read) { HWY_DYNAMIC_DISPATCH(read_all)(read); }

}  // namespace gw::fast
#endif  // HWY_ONCE
