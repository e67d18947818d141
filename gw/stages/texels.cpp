#include "gw/stages/texels.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "gw/base/to_bytes.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gw {
namespace {

/// The rounding of 16-bit values.
struct ToBits {
    int texel_bits, bits;
    static std::uint32_t color(std::uint32_t v) { return v; }
    std::uint32_t operator()(std::uint32_t v) const {
        return rescale(rescale(v, 16, texel_bits), texel_bits, bits);
    }
};

/// Of sRGB colours; alpha is as it is.
struct ToLinear : ToBits {
    static std::uint32_t color(std::uint32_t v) {
        return srgb_values()[std::size_t(rescale(v, 16, 8))];
    }
};

/// Calls store(x, texel) for the rounded texels of a row.
template <class Round>
void round_row(const std::uint16_t* from, int count, Round round, const auto& store) {
    for (int x = 0; x < count; ++x, from += 4)
        store(x, Rgba{std::uint16_t(round(round.color(from[0]))),
                      std::uint16_t(round(round.color(from[1]))),
                      std::uint16_t(round(round.color(from[2]))), std::uint16_t(round(from[3]))});
}

/// The texels of a level without a border.
template <class Round>
void round_inner(Texels& t, const TexelLevel& level, const TextureLevel& from, const Rect& part,
                 Round round) {
    for (int y = part.y; y < part.y + part.height; ++y) {
        const std::uint16_t* const row = &from.rgba[4 * pixel_index(part.x, y, level.width)];
        const std::size_t at = level.index(part.x, y);
        if (t.bits == 8)
            round_row(row, part.width, round,
                      [to = &t.packed[at]](int x, const Rgba& c) { to[x] = packed(c); });
        else
            round_row(row, part.width, round,
                      [to = &t.wide[at]](int x, const Rgba& c) { to[x] = c; });
    }
}

/// The same of the usual 8 bits, channel by channel: R is the first byte of a word.
void round_to_bytes(Texels& t, const TexelLevel& level, const TextureLevel& from,
                    const Rect& part) {
    for (int y = part.y; y < part.y + part.height; ++y) {
        const std::uint16_t* const row = &from.rgba[4 * pixel_index(part.x, y, level.width)];
        rescale_to_bytes({row, 4 * std::size_t(part.width)},
                         reinterpret_cast<std::uint8_t*>(&t.packed[level.index(part.x, y)]));
    }
}

/// The texels of a level with a border. In one dimension the rows above and below repeat the one
/// row: t is 0 there.
template <class Round>
void round_bordered(Texels& t, TexelLevel& level, const TextureLevel& from, const Rect& part,
                    Round round) {
    const int width = level.width + 2, copies = t.dimensions == 1 ? 3 : 1;
    const auto store = [&](int i, int j, const Rgba& texel) {
        level.bordered[pixel_index(i + 1, j + 1, width)] = texel;
        if (i >= 0 && i < level.width && j >= 0 && j < level.height)
            t.set(level.index(i, j), texel);
    };
    for (int y = part.y; y < part.y + part.height; ++y)
        round_row(&from.rgba[4 * pixel_index(part.x, y, width)], part.width, round,
                  [&](int x, const Rgba& texel) {
                      for (int k = 0; k < copies; ++k) store(part.x + x - 1, y + k - 1, texel);
                  });
}

/// Takes a rectangle of a level's stored texels over.
void round_part(Texels& t, TexelLevel& level, const TextureLevel& from, const Rect& part,
                int texel_bits) {
    constexpr bool is_little = std::endian::native == std::endian::little;
    if (is_little && t.bits == 8 && texel_bits == 8 && !t.srgb && level.bordered.empty())
        return round_to_bytes(t, level, from, part);
    const auto take = [&](auto round) {
        if (level.bordered.empty())
            round_inner(t, level, from, part, round);
        else
            round_bordered(t, level, from, part, round);
    };
    if (t.srgb)
        take(ToLinear{{texel_bits, t.bits}});
    else
        take(ToBits{texel_bits, t.bits});
}

constexpr std::uint32_t one_bits = 0x3F800000;        // of 1.0f
constexpr std::uint32_t root_two_bits = 0x3FB504F3;   // of sqrt(2), rounded down
constexpr std::uint32_t root_half_bits = 0x3F3504F4;  // of sqrt(1/2), rounded up

}  // namespace

const std::array<std::uint16_t, 256>& srgb_values() {
    static const std::array<std::uint16_t, 256> table = [] {
        std::array<std::uint16_t, 256> t{};
        for (std::size_t i = 0; i < 256; ++i) {
            const double v = double(i) / 255;
            const double linear = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
            t[i] = static_cast<std::uint16_t>(quantize(linear, 16));
        }
        return t;
    }();
    return table;
}

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

TexelLevel& Texels::add_level(int width, int height, int layers) {
    TexelLevel& level = add_empty_level(width, height, layers);
    const std::size_t end = level.first + level.layer_size() * std::size_t(layers);
    if (bits == 8)
        packed.resize(end);
    else
        wide.resize(end);
    return level;
}

TexelLevel& Texels::add_empty_level(int width, int height, int layers) {
    if (levels.empty()) any_size = is_any_size(width, height);
    return levels.emplace_back(TexelLevel{width,
                                          height,
                                          layers,
                                          std::countr_zero(unsigned(width)),
                                          std::countr_zero(unsigned(height)),
                                          std::max(packed.size(), wide.size()),
                                          {}});
}

/// Depths of all texels of a level, and the greys that they are without comparison.
void round_depths(Texels& t, const TexelLevel& level, const TextureLevel& from,
                  const TexelBits& bits) {
    const auto one = static_cast<std::uint16_t>(max_of_bits(t.bits));
    for (std::size_t i = 0; i < from.rgba.size() / 4; ++i) {
        const std::uint32_t given = std::uint32_t{from.rgba[4 * i]} << 16 | from.rgba[4 * i + 1];
        const std::uint32_t depth = given >> (32 - bits.depth);
        const auto grey = static_cast<std::uint16_t>(rescale(depth, bits.depth, t.bits));
        t.depths[level.first + i] = depth;
        t.set(level.first + i, completed(t.format, {grey, grey, grey, grey}, one));
    }
}

/// The whole level as one rectangle: its layers lie one above the other.
Rect all_layers(const Texture& texture, const TextureLevel& level) {
    Rect rect = stored_rect(texture, level);
    rect.height *= level.layers;
    return rect;
}

Texels make_texels(const Texture& texture, const TexelBits& bits) {
    Texels t{bits.color, texture.format, texture.dimensions};
    t.srgb = texture.srgb;
    t.cube = texture.cube;
    t.with_r = needs_r(texture);
    std::size_t count = 0;
    for (const TextureLevel& from : texture.levels)
        count += std::size_t(from.width) * std::size_t(from.height) * std::size_t(from.layers);
    if (texture.depths) {
        t.depths.resize(count);
        t.depth_bits = bits.depth;
    }
    if (t.bits == 8)
        t.packed.reserve(count);
    else
        t.wide.reserve(count);
    for (const TextureLevel& from : texture.levels) {
        TexelLevel& level = t.add_level(from.width, from.height, from.layers);
        if (texture.border)
            level.bordered.resize(std::size_t(from.width + 2) * std::size_t(from.height + 2));
        if (texture.depths)
            round_depths(t, level, from, bits);
        else
            round_part(t, level, from, all_layers(texture, from), bits.texel);
    }
    return t;
}

void update_texels(Texels& texels, const Texture& texture, const TexturePart& part,
                   const TexelBits& bits) {
    const auto i = std::size_t(part.level);
    if (texture.depths) return round_depths(texels, texels.levels[i], texture.levels[i], bits);
    round_part(texels, texels.levels[i], texture.levels[i], part.rect, bits.texel);
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

int clamped_position(Wrap wrap, int u, int size) {
    return wrap == Wrap::BorderClamp ? std::clamp(u, 0, size * 256) : u;
}

static bool is_outside(const TexelLevel& level, int i, int j) {
    return i < 0 || i >= level.width || j < 0 || j >= level.height;
}

/// Of wrapped indices.
static Rgba texel_or_border(const Texels& texels, const TexelLevel& level, const Addressing& how,
                            int i, int j, int layer) {
    if (!is_outside(level, i, j)) return texels.at(level, i, j, layer);
    return level.bordered.empty() ? how.border_color
                                  : level.bordered[pixel_index(i + 1, j + 1, level.width + 2)];
}

Rgba filter_texel(const Texels& texels, const TexelLevel& level, const Addressing& how, int i,
                  int j, int layer) {
    return texel_or_border(texels, level, how, filter_index(how.wrap_s, i, level.width),
                           filter_index(how.wrap_t, j, level.height), layer);
}

std::uint32_t nearest_depth(const Texels& texels, const TexelLevel& level, const Addressing& how,
                            int i, int j, double border) {
    return nearest_depth(level, how, i, j, texels.depth_bits, border,
                         [&](int x, int y) { return texels.depths[level.index(x, y)]; });
}

Rgba lookup(const Texels& texels, const TexelLevel& level, bool linear, const Addressing& how,
            int u, int v, int layer) {
    const Wrap wrap_s = how.wrap_s, wrap_t = how.wrap_t;
    if (!linear)
        return texel_or_border(texels, level, how, wrap_index(wrap_s, u >> 8, level.width),
                               wrap_index(wrap_t, v >> 8, level.height), layer);
    // to the lower left of the four centres
    const int us = clamped_position(wrap_s, u, level.width) - 128,
              vs = clamped_position(wrap_t, v, level.height) - 128;
    const int i = us >> 8, j = vs >> 8;
    const auto at = [&](int x, int y) { return filter_texel(texels, level, how, x, y, layer); };
    const Rgba a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
    Rgba out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = bilinear(a[k], b[k], c[k], d[k], std::uint32_t(us & 255), std::uint32_t(vs & 255),
                          texels.bits);
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
    const auto [base, last] = level_range(s, level_count);
    if (bits <= (later ? root_two_bits : one_bits)) return {.magnify = true, .level = base};

    const auto level_from = [bits, first = base](std::uint32_t origin) {
        return first + ((std::int32_t(bits) - std::int32_t(origin)) >> 23);
    };
    switch (s.min_filter) {
        case MinFilter::Nearest:
        case MinFilter::Linear: return {.level = base};
        case MinFilter::NearestMipmapNearest:
        case MinFilter::LinearMipmapNearest: {
            const int level = std::clamp(level_from(root_half_bits), base, last);
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
