// A texture: an immutable pyramid of RGBA images. docs/manual/texture.md, "Textures".
// Does not read files (image/ does) and does not filter (the machines do).
#pragma once

#include "gw/base/shared_value.h"
#include "gw/base/types.h"

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gw {

/// The values of a level's texels. Copies share them until one of them is edited.
class TexelValues : public SharedValue<std::vector<std::uint16_t>> {
public:
    TexelValues() = default;
    TexelValues(std::vector<std::uint16_t> values) : SharedValue(std::move(values)) {}
    TexelValues(std::initializer_list<std::uint16_t> values)
        : TexelValues(std::vector<std::uint16_t>(values)) {}

    std::size_t size() const { return (*this)->size(); }
    const std::uint16_t* data() const { return (*this)->data(); }
    const std::uint16_t& operator[](std::size_t i) const { return (**this)[i]; }
    auto begin() const { return (*this)->begin(); }
    auto end() const { return (*this)->end(); }
};

/// One level. A texel has 4 channels of 16 bits, which represent 0 .. 1; an 8-bit channel v is
/// stored as 257 v. Row 0 is t = 0 (bottom), column 0 is s = 0.
struct TextureLevel {
    int width = 1, height = 1;
    TexelValues rgba;
    /// of three dimensions: slices from r = 0 on; of a cube: 6 faces, +x, -x, +y, -y, +z, -z
    int layers = 1;
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

/// A rectangle of the texels that a level stores.
struct TexturePart {
    int level = 0;
    Rect rect;
};

/// Textures of one origin follow from each other: each replaces parts of the one before. So a machine
/// brings up to date what it keeps of an earlier one.
class TextureHistory {
public:
    bool is_empty() const { return !origin_; }
    /// A history of no other texture.
    static TextureHistory begin();
    void replace(const TexturePart& part);

    std::weak_ptr<const void> origin() const { return origin_; }
    const void* address() const { return origin_.get(); }
    /// Counts the parts that were replaced.
    std::uint64_t number() const { return number_; }
    /// Whether the parts that were replaced since a number are known, and these.
    bool knows_since(std::uint64_t number) const {
        return number <= number_ && number_ - number <= parts_.size();
    }
    std::span<const TexturePart> since(std::uint64_t number) const {
        return std::span(parts_).last(number_ - number);
    }

private:
    std::shared_ptr<const void> origin_;
    std::uint64_t number_ = 0;
    std::vector<TexturePart> parts_;  ///< the last ones
};

/// Levels from the given image down to 1x1, or as they were given.
struct Texture {
    std::string name;  ///< for messages and printed passes; not part of its value
    std::vector<TextureLevel> levels;
    TextureFormat format = TextureFormat::RGBA;
    int dimensions = 2;         ///< 1: t is 0, the height 1; 3: extension texture_3d
    bool border = false;        ///< levels have a texel more on each side (1D: left and right)
    bool given_levels = false;  ///< levels do not follow from the first
    bool srgb = false;          ///< extension texture_srgb: R, G, B are encoded as in sRGB
    bool cube = false;          ///< extension texture_cube: six square faces of two dimensions
    /// extension texture_depth: a texel is a depth of 32 bits, R its high and G its low half. Format
    /// Luminance, Intensity or Alpha
    bool depths = false;
    TextureHistory history;  ///< not part of its value

    int width() const { return levels.front().width; }
    int height() const { return levels.front().height; }
};

/// Whether look-ups need r at each pixel.
constexpr bool needs_r(const Texture& t) { return t.dimensions == 3 || t.cube || t.depths; }

/// The texels that a layer of a level stores, with its border: from 0, 0 on.
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

/// The largest side of an image, and of a texture without extension texture_sizes.
inline constexpr int max_texture_size = 4096;
/// The largest side of a texture.
inline constexpr int max_texture_side = 8192;
/// The largest side of a texture of three dimensions.
inline constexpr int max_volume_side = 512;
/// Whether a side is no power of two, or larger than max_texture_size: extension texture_sizes.
constexpr bool is_any_size(int width, int height) {
    const auto is_plain = [](int side) {
        return (side & (side - 1)) == 0 && side <= max_texture_size;
    };
    return !is_plain(width) || !is_plain(height);
}

/// Makes a texture from `width` x `height` RGBA texels of 16 bits, bottom row first. A side that is
/// not a power of two is resampled to the next larger one by integer bilinear interpolation. Levels
/// are means of 2x2 texels. Throws Error if a side is outside 1 .. max_texture_size or the number
/// of values is not 4 width height.
TextureRef make_texture(std::string name, int width, int height,
                        std::span<const std::uint16_t> rgba);

/// The same of an image of any size up to max_texture_side, which is not resampled.
TextureRef make_whole_texture(std::string name, int width, int height,
                              std::span<const std::uint16_t> rgba, bool srgb = false);

/// A texture of given levels, each half as large as the one before, as many as there are. `rgba` of a
/// level with a border has (width + 2) (height + 2) texels, 1D (width + 2). Channels that the format
/// lacks are taken from R (luminance, intensity) or replaced. Throws Error where sizes do not fit.
TextureRef make_texture(Texture given);

/// The next level: means over the part that a texel covers, of each face or of slices too.
TextureLevel next_level(const TextureLevel& level, int dimensions);

/// A texture of one image, as above, from 8-bit texels.
TextureRef make_texture8(std::string name, int width, int height,
                         std::span<const std::uint8_t> rgba);

/// A texture of given levels whose texels have all channels: `given.levels` are shared, and its history goes on.
TextureRef share_texture(Texture given);

/// Gives texels the channels that the format lacks.
void complete(TextureFormat format, std::span<std::uint16_t> rgba);

}  // namespace gw
