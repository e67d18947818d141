// Reads the colour plane back: a block's four channels become pixels side by side.
// docs/manual.md, "Pixels"; scalar twin: gw/reference/pixels.cpp. Does not know passes or counts.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/read.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/simd/lanes-inl.h"
#include "gw/fast/tile/read.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32

/// A block's four rows, each in one vector.
HWY_INLINE void put_block(const ColorBlock& block, Rgba* lowest, std::ptrdiff_t width) {
    const D16 d;
    const hn::Repartition<std::uint32_t, D16> pairs;
    const auto channel = [&](std::size_t c) { return hn::Load(d, block.channel[c]); };
    const auto store = [&](int row, auto v) {
        hn::StoreU(hn::BitCast(d, v), d, lowest[row * width].data());
    };
    const auto low = [&](std::size_t c) {
        return hn::BitCast(pairs, hn::InterleaveLower(d, channel(c), channel(c + 1)));
    };
    const auto high = [&](std::size_t c) {
        return hn::BitCast(pairs, hn::InterleaveUpper(d, channel(c), channel(c + 1)));
    };
    // Rows 0 and 2, then 1 and 3: vectors are interleaved by halves.
    const auto two_rows = [&](int row, auto rg, auto ba) {
        const auto left = hn::InterleaveLower(pairs, rg, ba),
                   right = hn::InterleaveUpper(pairs, rg, ba);
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

/// Words of R, G, B, A from the lowest byte, and of B, G, R, 0.
struct RgbaWord {
    std::uint32_t word;
};
struct BgrWord {
    std::uint32_t word;
};

template <class Word>
HWY_INLINE V32 words_of(V32 r, V32 g, V32 b, V32 a) {
    if constexpr (std::is_same_v<Word, BgrWord>)
        return hn::Or(hn::Or(b, hn::ShiftLeft<8>(g)), hn::ShiftLeft<16>(r));
    else
        return hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)),
                      hn::ShiftLeft<16>(hn::Or(b, hn::ShiftLeft<8>(a))));
}

/// A block's colours as words.
template <class Word>
HWY_INLINE void put_block(const ColorBlock& block, Word* lowest, std::ptrdiff_t width) {
    const D32 d;
    alignas(64) std::uint32_t words[block_pixels];
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto channel = [&](std::size_t c) { return load_channel(block.channel[c] + i); };
        hn::Store(words_of<Word>(channel(0), channel(1), channel(2), channel(3)), d, words + i);
    }
    for (int row = 0; row < block_side; ++row)
        std::memcpy(lowest + row * width, words + row * block_side, sizeof(Word) * block_side);
}

HWY_INLINE Rgba pixel_of(const Rgba& color, const Rgba*) { return color; }
HWY_INLINE RgbaWord pixel_of(const Rgba& color, const RgbaWord*) { return {packed(color)}; }
HWY_INLINE BgrWord pixel_of(const Rgba& color, const BgrWord*) {
    return {packed({color[2], color[1], color[0], 0})};
}

/// A block of one colour.
template <class Pixel>
HWY_INLINE void put_color(std::uint64_t color, Pixel* lowest, std::ptrdiff_t width) {
    const Pixel pixel = pixel_of(std::bit_cast<Rgba>(color), lowest);
    for (int row = 0; row < block_side; ++row) std::fill_n(lowest + row * width, block_side, pixel);
}
/// Four blocks side by side, each of one colour.
template <class Pixel>
HWY_INLINE void put_colors(const std::uint64_t* color, Pixel* lowest, std::ptrdiff_t width) {
    for (int i = 0; i < group_blocks; ++i) put_color(color[i], lowest + i * block_side, width);
}

#if HWY_MAX_BYTES >= 64

alignas(64) inline constexpr std::int32_t fourths[16] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                         2, 2, 2, 2, 3, 3, 3, 3};

HWY_INLINE void put_colors(const std::uint64_t* color, RgbaWord* lowest, std::ptrdiff_t width) {
    const D32 d;
    const hn::FixedTag<std::uint64_t, group_blocks> d64;
    const hn::Repartition<std::uint16_t, decltype(d64)> d16;
    const hn::FixedTag<std::uint8_t, block_pixels> d8;
    const auto words = hn::TruncateTo(d8, hn::BitCast(d16, hn::Load(d64, color)));
    alignas(16) std::uint32_t four[group_blocks];
    hn::Store(hn::BitCast(hn::FixedTag<std::uint32_t, group_blocks>(), words),
              hn::FixedTag<std::uint32_t, group_blocks>(), four);
    const auto each = hn::SetTableIndices(d, fourths);
    const auto line = hn::TableLookupLanes(hn::LoadDup128(d, four), each);
    for (int row = 0; row < block_side; ++row) hn::StoreU(line, d, &lowest[row * width].word);
}

#endif  // HWY_MAX_BYTES >= 64

/// Four blocks side by side, which belong to one group.
template <class Pixel>
HWY_INLINE void put_blocks(const Tile& tile, int x, int by, Pixel* lowest, std::ptrdiff_t width) {
    const UniformGroup& group = tile.group(x, by);
    const ColorBlock* block = &tile.color[tile.block(x, by)];
    const std::uint32_t first = tile.in_group(x, by), one = group.one_color >> first & 0xF;
    if (one == 0xF) return put_colors(group.color + first, lowest, width);
    for (int i = 0; i < group_blocks; ++i) {
        Pixel* to = lowest + i * block_side;
        if (one >> i & 1)
            put_color(group.color[first + std::uint32_t(i)], to, width);
        else
            put_block(block[i], to, width);
    }
}

/// The destination of the box's pixels, in rows.
template <class Pixel>
struct Target {
    const ReadColors& read;
    Pixel* bottom;         ///< the bottom row of the command
    std::ptrdiff_t pitch;  ///< from a row to the next higher one

    HWY_INLINE Target(const ReadColors& r, Pixel* out) : read(r), bottom(out), pitch(r.rect.width) {
        if (!r.layout.top_first) return;
        bottom = out + (r.rect.height - 1) * pitch;
        pitch = -pitch;
    }
    HWY_INLINE Pixel* row(int y) const {
        const Rect& rect = read.rect;
        return bottom + std::ptrdiff_t(read.tile.y + y - rect.y) * pitch +
               (read.tile.x + read.box.x0 - rect.x);
    }
    HWY_INLINE std::size_t width() const { return std::size_t(read.box.x1 - read.box.x0); }
    /// Starts to load rows into the cache.
    HWY_INLINE void prefetch(int first, int end) const {
        for (int y = first; y < std::min(end, read.box.y1); ++y)
            for (std::size_t x = 0; x < width(); x += 64 / sizeof(Pixel)) hwy::Prefetch(row(y) + x);
    }
};

/// Four blocks side by side that the box cuts.
template <class Pixel>
HWY_NOINLINE void read_cut_blocks(const Target<Pixel>& target, int x, int by) {
    constexpr int width = group_blocks * block_side;
    alignas(64) Pixel pixels[block_side * width];
    put_blocks(target.read.tile, x, by, pixels, width);
    const BlockBox& box = target.read.box;
    const int left = x * block_side, bottom = by * block_side;
    const int x0 = std::max(box.x0, left), x1 = std::min(box.x1, left + width);
    for (int y = std::max(box.y0, bottom); y < std::min(box.y1, bottom + block_side); ++y)
        std::copy_n(pixels + (y - bottom) * width + (x0 - left), x1 - x0,
                    target.row(y) + (x0 - box.x0));
}

/// The blocks of a group that share one colour.
HWY_INLINE KnownPixels::Part known_part(const UniformGroup& group) {
    if (group.one_color == 0) return {};
    const hn::CappedTag<std::uint64_t, 16> d;
    const std::uint64_t color = group.color[std::countr_zero(group.one_color)];
    std::uint32_t same = 0;
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d))
        same |= bits_of(d, hn::Eq(hn::Load(d, group.color + i), hn::Set(d, color)), hn::Lanes(d))
                << i;
    return {color, std::uint16_t(same & group.one_color)};
}

/// The blocks that the memory has already, by group of a row of groups.
struct KnownBlocks {
    std::array<std::uint32_t, 4> groups{};

    /// Notes what the memory has after this read.
    HWY_INLINE void find(const ReadColors& read, int by) {
        if (read.layout.known == nullptr) return;
        const int columns = (read.rect.width + group_side - 1) / group_side;
        KnownPixels::Part* const noted = &read.layout.known->parts[pixel_index(
            read.tile.x / group_side, (read.tile.y + by * block_side) / group_side, columns)];
        for (int i = 0; i * group_side < read.box.x1; ++i) {
            const KnownPixels::Part now = known_part(read.tile.group(i * group_blocks, by));
            groups[std::size_t(i)] = noted[i].color == now.color ? noted[i].blocks & now.blocks : 0;
            noted[i] = now;
        }
    }
    /// Whether four blocks side by side are known.
    HWY_INLINE bool has_row(int group, int by) const {
        return (groups[std::size_t(group)] >> by % group_blocks * group_blocks & 0xF) == 0xF;
    }
};

template <class Pixel>
HWY_INLINE void read_rows(const ReadColors& read, Pixel* out) {
    constexpr int width = group_side;
    const BlockBox& box = read.box;
    const Target<Pixel> target(read, out);
    KnownBlocks known;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by) {
        const int bottom = by * block_side, end = bottom + block_side;
        if (by % group_blocks == 0) known.find(read, by);
        target.prefetch(end, end + block_side);
        for (int left = box.x0 / width * width; left < box.x1; left += width) {
            if (known.has_row(left / width, by)) continue;
            const bool cut =
                left < box.x0 || left + width > box.x1 || bottom < box.y0 || end > box.y1;
            if (cut)
                read_cut_blocks(target, left / block_side, by);
            else
                put_blocks(read.tile, left / block_side, by, target.row(bottom) + (left - box.x0),
                           target.pitch);
        }
    }
}

void read_all(const ReadColors& read) {
    if (!read.packed)
        read_rows(read, read.out);
    else if (read.layout.blue_first)
        read_rows(read, reinterpret_cast<BgrWord*>(read.packed));
    else
        read_rows(read, reinterpret_cast<RgbaWord*>(read.packed));
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(read_all);

void read_colors(const ReadColors& read) { HWY_DYNAMIC_DISPATCH(read_all)(read); }

}  // namespace gw::fast
#endif  // HWY_ONCE
