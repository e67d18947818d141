// A texture: an immutable pyramid of RGBA images. docs/manual/texture.md, "Textures".
// Does not read files (image/ does) and does not filter (the machines do).
#pragma once

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

/// Levels from the given image down to 1x1.
struct Texture {
    std::string name;  ///< for messages and printed passes; not part of its value
    std::vector<TextureLevel> levels;

    int width() const { return levels.front().width; }
    int height() const { return levels.front().height; }
};

using TextureRef = std::shared_ptr<const Texture>;

/// The largest side of a texture.
inline constexpr int max_texture_size = 4096;

/// Makes a texture from `width` x `height` RGBA texels of 16 bits, bottom row first. A side that is
/// not a power of two is resampled to the next larger one by integer bilinear interpolation. Levels
/// are means of 2x2 texels. Throws Error if a side is outside 1 .. max_texture_size or the number
/// of values is not 4 width height.
TextureRef make_texture(std::string name, int width, int height,
                        std::span<const std::uint16_t> rgba);

/// The same from 8-bit texels.
TextureRef make_texture8(std::string name, int width, int height,
                         std::span<const std::uint8_t> rgba);

}  // namespace gw
