// A texture in the machine's colour bits, its addressing, and its filters on integers.
// docs/manual/texture.md, "Textures". Does not interpolate coordinates: each machine does.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/base/types.h"
#include "gw/profile.h"
#include "gw/state.h"
#include "gw/texture.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw {

struct TexelLevel {
    int width = 1, height = 1;
    int layers = 1;                       ///< of three dimensions or a cube
    int log2_width = 0, log2_height = 0;  ///< of sides that are powers of two
    std::size_t first = 0;                ///< its first texel, among those of all levels
    /// its texels with the border around them, (width + 2) (height + 2); empty: there is none
    std::vector<Rgba> bordered;
    std::size_t index(int i, int j, int layer = 0) const {
        return first + std::size_t(layer) * layer_size() + pixel_index(i, j, width);
    }
    std::size_t layer_size() const { return std::size_t(width) * std::size_t(height); }
};

/// The texels of a draw: colours, or depths for shadow_compare.
struct Texels {
    int bits = 8;
    TextureFormat format = TextureFormat::RGBA;
    int dimensions = 2;
    bool any_size = false;  ///< is_any_size() of level 0
    bool srgb = false;      ///< made of an sRGB texture
    bool cube = false;
    bool with_r = false;  ///< needs_r() of the texture
    std::vector<TexelLevel> levels;
    std::vector<std::uint32_t> packed;  ///< all levels' texels if bits == 8: packed()
    std::vector<Rgba> wide;             ///< else
    std::vector<std::uint32_t> depths;  ///< of a depth plane or texture, as many as texels
    int depth_bits = 0;                 ///< of `depths`

    /// A level more, of black texels.
    TexelLevel& add_level(int width, int height, int layers = 1);
    /// A level more, whose texels are kept elsewhere.
    TexelLevel& add_empty_level(int width, int height, int layers = 1);
    void set(std::size_t index, const Rgba& texel) {
        if (bits == 8)
            packed[index] = gw::packed(texel);
        else
            wide[index] = texel;
    }
    Rgba at(const TexelLevel& level, int i, int j, int layer = 0) const {
        const std::size_t index = level.index(i, j, layer);
        return bits == 8 ? unpacked(packed[index]) : wide[index];
    }
};

/// The textures of a command by unit; null: off.
using BoundTexels = std::array<const Texels*, max_texture_units>;

/// The bits of a texel's channel, of the colour that it becomes, and of depths.
struct TexelBits {
    int texel, color, depth;
};
constexpr TexelBits texel_bits_of(const Profile& p) {
    return {texel_bits(p), p.color_bits, p.depth_bits};
}
/// Levels rounded from 16 bits to `bits.texel`, then to `bits.color`; depths to `bits.depth`.
Texels make_texels(const Texture& texture, const TexelBits& bits);
/// The linear value of each byte of sRGB, of 16 bits.
const std::array<std::uint16_t, 256>& srgb_values();
/// Takes a part over from a texture with the same levels.
void update_texels(Texels& texels, const Texture& texture, const TexturePart& part,
                   const TexelBits& bits);

/// i modulo n, 0 .. n - 1.
constexpr int modulo(int i, int n) { return (n & (n - 1)) == 0 ? i & (n - 1) : (i % n + n) % n; }

/// A texel index folded into 0 .. size - 1, under ClampToBorder into -1 .. size.
constexpr int wrap_index(Wrap wrap, int i, int size) {
    switch (wrap) {
        case Wrap::Repeat: return modulo(i, size);
        case Wrap::Clamp:
        case Wrap::BorderClamp: return i < 0 ? 0 : i < size ? i : size - 1;
        case Wrap::ClampToBorder: return i < 0 ? -1 : i < size ? i : size;
        case Wrap::MirroredRepeat: {
            const int folded = modulo(i, 2 * size);
            return folded < size ? folded : 2 * size - 1 - folded;
        }
    }
    return 0;
}

/// Bilinear mean of a b (lower row) and c d (upper row), weights wx, wy in 0 .. 255 of 256.
std::uint16_t bilinear(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                       std::uint32_t wx, std::uint32_t wy, int bits);

/// How a level is looked up.
struct Addressing {
    Wrap wrap_s = Wrap::Repeat, wrap_t = Wrap::Repeat;
    Rgba border_color{};  ///< of levels without a border
    Wrap wrap_r = Wrap::Repeat;
    bool operator==(const Addressing&) const = default;
};

/// In one dimension t does not wrap.
inline Addressing addressing(const TextureState& s, const Texels& texels,
                             const Rgba& border_color) {
    const auto one = static_cast<std::uint16_t>((1u << texels.bits) - 1);
    if (texels.cube) return {Wrap::Clamp, Wrap::Clamp};
    return {s.wrap_s, texels.dimensions == 1 ? Wrap::Clamp : s.wrap_t,
            completed(texels.format, border_color, one), s.wrap_r};
}

/// The texel at u, v, or the mean of the four texels around it. Coordinates are in units of 1/256
/// texel; texel i is [256 i, 256 i + 256).
Rgba lookup(const Texels& texels, const TexelLevel& level, bool linear, const Addressing& how,
            int u, int v, int layer = 0);

/// The texel that a linear filter sees at (i, j), at most one texel outside the level.
Rgba filter_texel(const Texels& texels, const TexelLevel& level, const Addressing& how, int i,
                  int j, int layer = 0);
/// BorderClamp keeps a position within the level; its filter reaches half a texel beyond.
int clamped_position(Wrap wrap, int u, int size);
/// A texel index of a linear filter: -1 and `size` are the border, under BorderClamp only.
constexpr int filter_index(Wrap wrap, int i, int size) {
    return wrap == Wrap::BorderClamp ? i : wrap_index(wrap, i, size);
}

/// The depth at texel (i, j) of a level, at(i, j) within it; outside of it that of the border, 0 .. 1.
template <class At>
std::uint32_t nearest_depth(const TexelLevel& level, const Addressing& how, int i, int j, int bits,
                            double border, const At& at) {
    i = wrap_index(how.wrap_s, i, level.width);
    j = wrap_index(how.wrap_t, j, level.height);
    const bool is_inside = i >= 0 && j >= 0 && i < level.width && j < level.height;
    return is_inside ? at(i, j) : std::uint32_t(quantize(border, bits));
}
/// The same of texels that have depths.
std::uint32_t nearest_depth(const Texels& texels, const TexelLevel& level, const Addressing& how,
                            int i, int j, double border);

/// The mean of two levels, weight f in 0 .. 255 of 256 for `b`.
Rgba between_levels(const Rgba& a, const Rgba& b, std::uint32_t f);

/// Fractions of a level in 256ths by the high 8 bits i of rho's mantissa: round(256 log2(1 + i /
/// 256)), at most 255.
const std::array<std::uint32_t, 256>& mantissa_levels();

/// The levels of texture.lod that are there.
struct LevelRange {
    int base, last;
};
constexpr LevelRange level_range(const TextureState& s, int level_count) {
    const int end = level_count - 1, base = s.lod.base_level < end ? s.lod.base_level : end;
    return {base, s.lod.max_level < base ? base : s.lod.max_level < end ? s.lod.max_level : end};
}

/// The levels for the scale factor rho (texels per pixel, >= 0). [GL11] 3.8.1
struct LevelChoice {
    bool magnify = false;
    int level = 0;             ///< first level
    int next = 0;              ///< second level of a mipmap-linear filter
    std::uint32_t weight = 0;  ///< of `next`, 0 .. 255
};
LevelChoice choose_level(const TextureState& state, float rho, int level_count);

/// Whether the filter averages four texels of a level.
constexpr bool is_linear(const TextureState& s, bool magnify) {
    if (magnify) return s.mag_filter == MagFilter::Linear;
    return s.min_filter == MinFilter::Linear || s.min_filter == MinFilter::LinearMipmapNearest ||
           s.min_filter == MinFilter::LinearMipmapLinear;
}

/// Whether wraps and levels are those of OpenGL 1.1.
constexpr bool is_plain_lookup(const TextureState& s) {
    return s.wrap_s <= Wrap::BorderClamp && s.wrap_t <= Wrap::BorderClamp &&
           s.lod == TextureLodState{};
}

/// Whether a filter of OpenGL 1.1 may reach the border.
constexpr bool reaches_border(const TextureState& s) {
    return (s.wrap_s == Wrap::BorderClamp || s.wrap_t == Wrap::BorderClamp) &&
           (is_linear(s, false) || is_linear(s, true));
}

/// Whether the filters depend on rho.
constexpr bool needs_rho(const TextureState& s) {
    return !(s.min_filter == MinFilter::Linear && s.mag_filter == MagFilter::Linear) &&
           !(s.min_filter == MinFilter::Nearest && s.mag_filter == MagFilter::Nearest);
}

}  // namespace gw
