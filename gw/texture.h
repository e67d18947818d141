// A texture: an immutable pyramid of RGBA images. docs/manual.md, "Textures".
// Does not read files (image/ does) and does not filter (the machines do).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gw {

/// One level, 16 bits a channel normalised to 0..1 (an 8-bit texel v is stored as 257 v), 4
/// channels a texel, row 0 is t = 0 (bottom), column 0 is s = 0.
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

/// Makes a texture from `width` x `height` RGBA texels of 16 bits, bottom row first. Sides that are
/// not powers of two are resampled to the nearest larger one by integer bilinear interpolation;
/// levels are made by 2x2 means. Throws Error when a side is outside 1 .. max_texture_size or the
/// number of values is not 4 width height.
TextureRef make_texture(std::string name, int width, int height,
                        std::span<const std::uint16_t> rgba);

/// The same from 8-bit texels.
TextureRef make_texture8(std::string name, int width, int height,
                         std::span<const std::uint8_t> rgba);

}  // namespace gw
