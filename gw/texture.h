// A texture: an immutable pyramid of RGBA images. docs/manual/texture.md, "Textures".
// Does not read files (image/ does) and does not filter (the machines do).
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gw {

/// One level. A texel has 4 channels of 16 bits, which represent 0 .. 1; an 8-bit channel v is
/// stored as 257 v. Row 0 is t = 0 (bottom), column 0 is s = 0.
struct TextureLevel {
    int width = 1, height = 1;  ///< powers of two
    std::vector<std::uint16_t> rgba;
    bool operator==(const TextureLevel&) const = default;
};

/// The base internal formats of [GL11] table 3.8: the channels that a texel has. The others hold what
/// changes nothing under Modulate.
enum class TextureFormat : std::uint8_t {
    RGBA,
    RGB,             ///< A is 1
    LuminanceAlpha,  ///< R = G = B
    Luminance,       ///< R = G = B, A is 1
    Alpha,           ///< R, G, B are 1
    Intensity,       ///< R = G = B = A
};

/// Levels from the given image down to 1x1, or as they were given.
struct Texture {
    std::string name;  ///< for messages and printed passes; not part of its value
    std::vector<TextureLevel> levels;
    TextureFormat format = TextureFormat::RGBA;
    int dimensions = 2;         ///< 1: t is 0, the height 1
    bool border = false;        ///< levels have a texel more on each side (1D: left and right)
    bool given_levels = false;  ///< levels do not follow from the first

    int width() const { return levels.front().width; }
    int height() const { return levels.front().height; }
};

/// The texels that a level stores, with its border: from 0, 0 on.
constexpr Rect stored_rect(const Texture& t, const TextureLevel& level) {
    const int more = t.border ? 2 : 0;
    return {0, 0, level.width + more, level.height + (t.dimensions == 2 ? more : 0)};
}

/// A texel with values in the channels that its format lacks; `one` stands for 1.
constexpr Rgba completed(TextureFormat format, Rgba texel, std::uint16_t one) {
    const bool grey = format == TextureFormat::Luminance || format == TextureFormat::Intensity ||
                      format == TextureFormat::LuminanceAlpha;
    if (grey) texel[1] = texel[2] = texel[0];
    if (format == TextureFormat::Alpha) texel[0] = texel[1] = texel[2] = one;
    if (format == TextureFormat::Intensity) texel[3] = texel[0];
    if (format == TextureFormat::RGB || format == TextureFormat::Luminance) texel[3] = one;
    return texel;
}

using TextureRef = std::shared_ptr<const Texture>;

/// The largest side of a texture.
inline constexpr int max_texture_size = 4096;

/// Makes a texture from `width` x `height` RGBA texels of 16 bits, bottom row first. A side that is
/// not a power of two is resampled to the next larger one by integer bilinear interpolation. Levels
/// are means of 2x2 texels. Throws Error if a side is outside 1 .. max_texture_size or the number
/// of values is not 4 width height.
TextureRef make_texture(std::string name, int width, int height,
                        std::span<const std::uint16_t> rgba);

/// A texture of given levels, each half as large as the one before, as many as there are. `rgba` of a
/// level with a border has (width + 2) (height + 2) texels, 1D (width + 2). Channels that the format
/// lacks are taken from R (luminance, intensity) or replaced. Throws Error where sizes do not fit.
TextureRef make_texture(Texture given);

/// The same from 8-bit texels.
TextureRef make_texture8(std::string name, int width, int height,
                         std::span<const std::uint8_t> rgba);

}  // namespace gw
