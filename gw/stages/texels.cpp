#include "gw/stages/texels.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gw {
namespace {

/// One level's array of 16-bit values as texels.
std::vector<Rgba> rounded(const std::vector<std::uint16_t>& rgba, int bits, int texel_bits) {
    std::vector<Rgba> out(rgba.size() / 4);
    if (out.empty()) return out;
    const std::uint16_t* const from = rgba.data();
    std::uint16_t* const to = out.front().data();
    const auto round_all = [&](auto round) {
        for (std::size_t i = 0; i < 4 * out.size(); ++i)
            to[i] = static_cast<std::uint16_t>(round(from[i]));
    };
    if (bits == 8 && texel_bits == 8)  // rescale(v, 16, 8) = (v + 128) / 257
        round_all([](std::uint32_t v) { return (v + 128 - ((v + 128) >> 8)) >> 8; });
    else
        round_all(
            [&](std::uint32_t v) { return rescale(rescale(v, 16, texel_bits), texel_bits, bits); });
    return out;
}

/// The texels inside a border.
std::vector<Rgba> inner(const TexelLevel& level) {
    std::vector<Rgba> out;
    for (int j = 0; j < level.height; ++j)
        for (int i = 0; i < level.width; ++i)
            out.push_back(level.bordered[pixel_index(i + 1, j + 1, level.width + 2)]);
    return out;
}

/// In one dimension the rows above and below repeat the one row: t is 0 there.
std::vector<Rgba> three_rows(const std::vector<Rgba>& row) {
    std::vector<Rgba> out = row;
    out.insert(out.end(), row.begin(), row.end());
    out.insert(out.end(), row.begin(), row.end());
    return out;
}

TexelLevel make_level(const Texture& texture, const TextureLevel& from, int bits, int texel_bits) {
    TexelLevel level{from.width,
                     from.height,
                     std::countr_zero(unsigned(from.width)),
                     std::countr_zero(unsigned(from.height)),
                     rounded(from.rgba, bits, texel_bits),
                     {}};
    if (!texture.border) return level;
    level.bordered = texture.dimensions == 2 ? std::move(level.texels) : three_rows(level.texels);
    level.texels = inner(level);
    return level;
}

constexpr std::uint32_t one_bits = 0x3F800000;        // of 1.0f
constexpr std::uint32_t root_two_bits = 0x3FB504F3;   // of sqrt(2), rounded down
constexpr std::uint32_t root_half_bits = 0x3F3504F4;  // of sqrt(1/2), rounded up

}  // namespace

const std::array<std::uint32_t, 256>& mantissa_levels() {
    static const std::array<std::uint32_t, 256> table = [] {
        constexpr double ln2 = 0.693147180559945309417;
        std::array<std::uint32_t, 256> t{};
        for (std::size_t i = 0; i < 256; ++i)
            t[i] = std::min<std::uint32_t>(
                255, std::uint32_t(round_even(256 * (log(1 + double(i) / 256) / ln2))));
        return t;
    }();
    return table;
}

Texels make_texels(const Texture& texture, int bits, int texel_bits) {
    Texels t{bits, {}, {}, texture.format, texture.dimensions};
    for (const TextureLevel& level : texture.levels)
        t.levels.push_back(make_level(texture, level, bits, texel_bits));
    return t;
}

std::uint16_t bilinear(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                       std::uint32_t wx, std::uint32_t wy, int bits) {
    if (bits == 8) {  // two roundings of 15-bit products, for 16-bit lanes; error <= 0.516
        const auto row = [wx](std::uint32_t p, std::uint32_t q) {
            return std::int32_t(64 * p) +
                   (((std::int32_t(q) - std::int32_t(p)) * 64 * std::int32_t(wx) + 128) >> 8);
        };
        const std::int32_t t0 = row(a, b), t1 = row(c, d);
        return static_cast<std::uint16_t>((t0 + (((t1 - t0) * std::int32_t(wy) + 128) >> 8) + 32) >>
                                          6);
    }
    const std::uint32_t low = a * (256 - wx) + b * wx, high = c * (256 - wx) + d * wx;
    return static_cast<std::uint16_t>((low * (256 - wy) + high * wy + (1u << 15)) >> 16);
}

namespace {

/// BorderClamp keeps a position within the level; its filter reaches half a texel beyond.
int clamped(Wrap wrap, int u, int size) {
    return wrap == Wrap::BorderClamp ? std::clamp(u, 0, size * 256) : u;
}

/// A texel index of a linear filter: -1 and `size` are the border, under BorderClamp only.
int filter_index(Wrap wrap, int i, int size) {
    return wrap == Wrap::BorderClamp ? i : wrap_index(wrap, i, size);
}

}  // namespace

const Rgba& filter_texel(const TexelLevel& level, const Addressing& how, int i, int j) {
    i = filter_index(how.wrap_s, i, level.width);
    j = filter_index(how.wrap_t, j, level.height);
    const bool outside = i < 0 || i >= level.width || j < 0 || j >= level.height;
    if (!outside) return level.at(i, j);
    return level.bordered.empty() ? how.border_color
                                  : level.bordered[pixel_index(i + 1, j + 1, level.width + 2)];
}

Rgba lookup(const TexelLevel& level, bool linear, const Addressing& how, int u, int v, int bits) {
    const Wrap wrap_s = how.wrap_s, wrap_t = how.wrap_t;
    if (!linear)
        return level.at(wrap_index(wrap_s, u >> 8, level.width),
                        wrap_index(wrap_t, v >> 8, level.height));
    // to the lower left of the four centres
    const int us = clamped(wrap_s, u, level.width) - 128,
              vs = clamped(wrap_t, v, level.height) - 128;
    const int i = us >> 8, j = vs >> 8;
    const auto at = [&](int x, int y) { return filter_texel(level, how, x, y); };
    const Rgba a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
    Rgba out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = bilinear(a[k], b[k], c[k], d[k], std::uint32_t(us & 255), std::uint32_t(vs & 255),
                          bits);
    return out;
}

Rgba between_levels(const Rgba& a, const Rgba& b, std::uint32_t f) {
    Rgba out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = static_cast<std::uint16_t>(
            a[k] + (((std::int32_t(b[k]) - a[k]) * std::int32_t(f) + 128) >> 8));
    return out;
}

LevelChoice choose_level(const TextureState& s, float rho, int level_count) {
    const auto bits = std::bit_cast<std::uint32_t>(rho);
    const bool later =
        s.mag_filter == MagFilter::Linear && (s.min_filter == MinFilter::NearestMipmapNearest ||
                                              s.min_filter == MinFilter::NearestMipmapLinear);
    if (bits <= (later ? root_two_bits : one_bits)) return {.magnify = true};

    const int last = level_count - 1;
    const auto level_from = [&](std::uint32_t origin) {
        return (std::int32_t(bits) - std::int32_t(origin)) >> 23;
    };
    switch (s.min_filter) {
        case MinFilter::Nearest:
        case MinFilter::Linear: return {};
        case MinFilter::NearestMipmapNearest:
        case MinFilter::LinearMipmapNearest: {
            const int level = std::clamp(level_from(root_half_bits), 0, last);
            return {.level = level, .next = level};
        }
        case MinFilter::NearestMipmapLinear:
        case MinFilter::LinearMipmapLinear: {
            const int level = level_from(one_bits);
            if (level >= last) return {.level = last, .next = last};
            return {
                .level = level, .next = level + 1, .weight = mantissa_levels()[(bits >> 15) & 255]};
        }
    }
    return {};
}

}  // namespace gw
