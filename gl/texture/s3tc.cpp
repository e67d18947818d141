#include "gl/texture/s3tc.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gw::gl {

namespace {

using Alpha = BlockFormat::Alpha;
constexpr BlockFormat block_formats[] = {
    {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, Alpha::One, 8},
    {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, Alpha::OneBit, 8},
    {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, Alpha::Explicit, 16},
    {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, Alpha::Interpolated, 16},
    {GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, Alpha::One, 8},
    {GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT, Alpha::OneBit, 8},
    {GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, Alpha::Explicit, 16},
    {GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT, Alpha::Interpolated, 16},
};

using Color = std::array<unsigned, 4>;  ///< 8 bits a channel

/// A number of `count` bytes, the lowest first.
std::uint64_t number(const std::byte* at, std::size_t count) {
    std::uint64_t out = 0;
    for (std::size_t i = count; i-- > 0;) out = out << 8 | std::to_integer<std::uint64_t>(at[i]);
    return out;
}

/// 5, 6 and 5 bits, the highest ones repeated below.
Color color_of(unsigned c) {
    const unsigned r = c >> 11, g = c >> 5 & 63, b = c & 31;
    return {r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2, 255};
}

Color between(const Color& a, unsigned weight_a, const Color& b, unsigned weight_b) {
    Color out{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = (weight_a * a[i] + weight_b * b[i]) / (weight_a + weight_b);
    return out;
}

/// The colours of the four codes.
std::array<Color, 4> palette(const std::byte* block, Alpha alpha) {
    const auto first = unsigned(number(block, 2)), second = unsigned(number(block + 2, 2));
    const Color a = color_of(first), b = color_of(second);
    const bool has_four =
        first > second || alpha == Alpha::Explicit || alpha == Alpha::Interpolated;
    if (has_four) return {a, b, between(a, 2, b, 1), between(a, 1, b, 2)};
    return {a, b, between(a, 1, b, 1), Color{0, 0, 0, alpha == Alpha::OneBit ? 0u : 255u}};
}

/// The alphas of the eight codes.
std::array<unsigned, 8> alphas(unsigned a, unsigned b) {
    std::array<unsigned, 8> out{a, b};
    const unsigned steps = a > b ? 7 : 5;
    for (unsigned i = 1; i < steps; ++i) out[i + 1] = ((steps - i) * a + i * b) / steps;
    if (a <= b) {
        out[6] = 0;
        out[7] = 255;
    }
    return out;
}

/// The alpha of a texel of a block that has 8 bytes of them.
unsigned alpha_of(const std::byte* block, Alpha alpha, std::size_t texel) {
    if (alpha == Alpha::Explicit) return unsigned(number(block, 8) >> 4 * texel & 15) * 17;
    const std::uint64_t codes = number(block + 2, 6);
    return alphas(unsigned(number(block, 1)),
                  unsigned(number(block + 1, 1)))[codes >> 3 * texel & 7];
}

/// The 16 texels of a block.
std::array<Rgba, 16> texels(const std::byte* block, Alpha alpha) {
    const bool has_alphas = alpha == Alpha::Explicit || alpha == Alpha::Interpolated;
    const std::byte* const colors = has_alphas ? block + 8 : block;
    const std::array<Color, 4> codes = palette(colors, alpha);
    const std::uint64_t chosen = number(colors + 4, 4);
    std::array<Rgba, 16> out{};
    for (std::size_t i = 0; i < 16; ++i) {
        Color c = codes[chosen >> 2 * i & 3];
        if (has_alphas) c[3] = alpha_of(block, alpha, i);
        for (std::size_t k = 0; k < 4; ++k) out[i][k] = std::uint16_t(257 * c[k]);
    }
    return out;
}

void put(std::byte* at, std::uint64_t number, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) at[i] = std::byte(number >> 8 * i & 255);
}

/// To nearest, as are all roundings here.
unsigned scaled(unsigned value, unsigned from, unsigned to) {
    return (value * to + from / 2) / from;
}

unsigned packed(const Color& c) {
    return scaled(c[0], 255, 31) << 11 | scaled(c[1], 255, 63) << 5 | scaled(c[2], 255, 31);
}

/// The square of the distance of two colours, without their alphas.
unsigned difference(const Color& a, const Color& b) {
    unsigned sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

using Block = std::array<Color, 16>;

bool is_hole(const Color& c, Alpha alpha) { return alpha == Alpha::OneBit && c[3] < 128; }

/// The two texels that differ most, the first of equals; holes do not count.
std::array<Color, 2> ends_of(const Block& block, Alpha alpha) {
    std::vector<Color> solid;
    std::ranges::copy_if(block, std::back_inserter(solid),
                         [&](const Color& c) { return !is_hole(c, alpha); });
    if (solid.empty()) return {};
    std::array<Color, 2> out{solid[0], solid[0]};
    unsigned most = 0;
    for (std::size_t i = 0; i < solid.size(); ++i)
        for (std::size_t k = i + 1; k < solid.size(); ++k) {
            const unsigned found = difference(solid[i], solid[k]);
            if (found <= most) continue;
            most = found;
            out = {solid[i], solid[k]};
        }
    return out;
}

/// The place of the first value whose distance is least.
template <class Value, class Distance>
std::uint64_t nearest(std::span<const Value> codes, Distance distance) {
    return std::uint64_t(std::ranges::min_element(codes, {}, distance) - codes.begin());
}

/// 8 bytes. With holes the first colour is not greater, else not less.
void put_colors(std::byte* at, const Block& block, Alpha alpha) {
    const bool has_holes =
        std::ranges::any_of(block, [&](const Color& c) { return is_hole(c, alpha); });
    const auto [a, b] = ends_of(block, alpha);
    unsigned first = packed(a), second = packed(b);
    if ((first < second) != has_holes) std::swap(first, second);
    put(at, first, 2);
    put(at + 2, second, 2);
    const std::array<Color, 4> codes = palette(at, alpha);
    const bool is_last_a_hole = alpha == Alpha::OneBit && first <= second;
    const std::span solid = std::span<const Color>(codes).first(is_last_a_hole ? 3 : 4);
    std::uint64_t chosen = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const auto distance = [&](const Color& c) { return difference(c, block[i]); };
        chosen |= (is_hole(block[i], alpha) ? 3 : nearest(solid, distance)) << 2 * i;
    }
    put(at + 4, chosen, 4);
}

/// 8 bytes, 4 bits a texel.
void put_explicit_alphas(std::byte* at, const Block& block) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < block.size(); ++i)
        bits |= std::uint64_t{scaled(block[i][3], 255, 15)} << 4 * i;
    put(at, bits, 8);
}

/// 8 bytes: the greatest and the least alpha, 3 bits a texel.
void put_interpolated_alphas(std::byte* at, const Block& block) {
    const auto [low, high] = std::ranges::minmax(block, {}, [](const Color& c) { return c[3]; });
    const std::array<unsigned, 8> codes = alphas(high[3], low[3]);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const unsigned alpha = block[i][3];
        const auto distance = [&](unsigned a) { return a > alpha ? a - alpha : alpha - a; };
        bits |= nearest(std::span<const unsigned>(codes), distance) << 3 * i;
    }
    put(at, high[3], 1);
    put(at + 1, low[3], 1);
    put(at + 2, bits, 6);
}

std::size_t blocks_of(GLsizei side) { return (std::size_t(side) + 3) / 4; }

}  // namespace

const BlockFormat* block_format(GLenum format) {
    const auto* const found =
        std::ranges::find(block_formats, format, [](const BlockFormat& f) { return f.format; });
    return found != std::end(block_formats) ? found : nullptr;
}

std::size_t blocks_size(const BlockFormat& format, GLsizei width, GLsizei height) {
    return blocks_of(width) * blocks_of(height) * format.bytes;
}

std::vector<Rgba> decoded(const BlockFormat& format, GLsizei width, GLsizei height,
                          std::span<const std::byte> blocks) {
    std::vector<Rgba> out(std::size_t(width) * std::size_t(height));
    const std::byte* block = blocks.data();
    for (int y = 0; y < height; y += 4)
        for (int x = 0; x < width; x += 4, block += format.bytes) {
            const std::array<Rgba, 16> in = texels(block, format.alpha);
            for (int j = 0; j < std::min(4, height - y); ++j)
                for (int i = 0; i < std::min(4, width - x); ++i)
                    out[pixel_index(x + i, y + j, width)] = in[std::size_t(4 * j + i)];
        }
    return out;
}

std::vector<std::byte> encoded(const BlockFormat& format, GLsizei width, GLsizei height,
                               std::span<const Rgba> texels) {
    std::vector<std::byte> out(blocks_size(format, width, height));
    std::byte* at = out.data();
    for (int y = 0; y < height; y += 4)
        for (int x = 0; x < width; x += 4, at += format.bytes) {
            Block block;  // beyond the image, its last texels
            for (std::size_t i = 0; i < block.size(); ++i) {
                const int column = std::min(x + int(i % 4), width - 1),
                          row = std::min(y + int(i / 4), height - 1);
                const Rgba& texel = texels[pixel_index(column, row, width)];
                for (std::size_t k = 0; k < 4; ++k) block[i][k] = scaled(texel[k], 65535, 255);
            }
            if (format.alpha == Alpha::Explicit) put_explicit_alphas(at, block);
            if (format.alpha == Alpha::Interpolated) put_interpolated_alphas(at, block);
            put_colors(at + format.bytes - 8, block, format.alpha);
        }
    return out;
}

}  // namespace gw::gl
