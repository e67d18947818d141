// Texture objects: parameters and images, and the machine's texture that they make. [GL11] 3.8
#pragma once

#include "gl/state/free_names.h"
#include "gl/state/state.h"
#include "gw/planes.h"
#include "gw/profile.h"
#include "gw/texture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace gw::gl {

/// max_texture_side = 2^13.
inline constexpr int level_count = 14;
/// The indices of texture_targets.
inline constexpr std::size_t one_dimension = 0, two_dimensions = 1, rectangular = 2,
                             three_dimensions = 3, cube = 4;
/// What a profile needs for each target; null: nothing.
inline constexpr std::array<bool Extensions::*, texture_target_count> texture_target_features{
    nullptr, nullptr, &Extensions::texture_sizes, &Extensions::texture_3d,
    &Extensions::texture_cube};
constexpr bool has_target(const Profile& p, std::size_t target) {
    const auto feature = texture_target_features[target];
    return feature == nullptr || p.extensions.*feature;
}
/// Whether images of a target have this level: rectangles have one. GL_ARB_texture_rectangle
constexpr bool has_level(std::size_t target, int level) {
    return level >= 0 && level < (target == rectangular ? 1 : level_count);
}
/// The largest side of a profile's textures.
constexpr int largest_texture(const Profile& p, std::size_t target = two_dimensions) {
    if (target == three_dimensions) return max_volume_side;
    return p.extensions.texture_sizes ? max_texture_side : max_texture_size;
}

/// One level's image, of a cube one face's. Channels that the base format lacks are those of complete().
struct TextureImage {
    int width = 0, height = 0;  ///< with the border; 0: no image
    int border = 0;
    GLint internal_format = 1;  ///< as it was given; see stored_format()
    /// 4 a texel, 0 .. 65535 is 0 .. 1, bottom row first. Empty: none were given, fill() makes them.
    TexelValues texels;
    /// The blocks as they were given; null: the format has none, or the level was made of another one.
    std::shared_ptr<const std::vector<std::byte>> blocks;
    int depth = 1;  ///< slices, with the border

    /// Texels that were not given are 0.
    void fill();
};
using TextureImages = std::array<TextureImage, level_count>;

/// The place of an image in its object.
struct ImageKey {
    std::size_t face = 0;  ///< of a cube; else 0
    std::size_t level = 0;
    auto operator<=>(const ImageKey&) const = default;
};
/// A slice of an image: what a framebuffer object can draw to.
struct ImageSlice {
    ImageKey key;
    int slice = 0;
    auto operator<=>(const ImageSlice&) const = default;
};
struct SurfaceImage;  ///< gl/drawable/off_screen.h
/// The planes of a slice, and where its newest values are.
struct RenderedImage {
    std::shared_ptr<SurfaceImage> image;
    PlaneMask newer = 0;               ///< planes newer than the texels: they were drawn to
    PlaneMask older = surface_planes;  ///< planes older than the texels: those were given since
};

/// Some texels of an image: a rectangle in each of some slices.
struct TexelBox {
    Rect rect;
    int slice = 0, slices = 1;
    std::size_t size() const { return rect.area() * std::size_t(slices); }
};

/// The machine's textures share the images' texels. So they are changed in place as long as no
/// frame draws with them.
struct TextureObject {
    TextureParameters parameters;
    TextureImages levels;                      ///< of a cube: of the face +x
    std::vector<TextureImages> further_faces;  ///< of a cube: -x, +y, -y, +z, -z; else none
    TextureHistory history;         ///< of `made`; parts of images that change belong to it
    bool changed = true;            ///< an image, since `made`
    bool made_with_levels = false;  ///< `made` has all levels, for filters that use them
    TextureRef made;                ///< null: there is no image
    int made_base = 0;              ///< the level that is its first
    std::size_t new_bytes = 0;      ///< of texels that were stored beside those that frames keep
    std::map<ImageSlice, RenderedImage> rendered;  ///< what framebuffer objects have or had

    TextureImage& image(const ImageKey& key) {
        return key.face == 0 ? levels[key.level] : further_faces[key.face - 1][key.level];
    }
    void set_image(const ImageKey& key, TextureImage image);
    void set_parameters(const TextureParameters& all);
    /// The number of the base level's image.
    std::size_t base_level() const {
        return std::size_t(std::min(parameters.base_level, level_count - 1));
    }
    const TextureImage& base() const { return levels[base_level()]; }
    /// Makes the levels after the base level of it, of one face. [GL14] 3.8.8
    void generate_levels(std::size_t face);
    /// Whether a part of an image can be replaced where it is: nobody else has the texels.
    bool is_alone(const ImageKey& key);
    /// `colors` are those of a box, which counts from the border.
    void replace_part(const ImageKey& key, const TexelBox& box, std::span<const Rgba> colors);
};

/// Makes the object one of this target, when it is bound first.
std::shared_ptr<TextureObject> new_texture(std::size_t target);

/// The index of a target; none: the profile has no such target.
std::optional<std::size_t> target_index(const Profile& profile, GLenum target);

/// The names of textures, and the objects. Contexts may share them. Name 0 has an object for each
/// target, of each context's own.
struct TextureNames {
    struct Named {
        GLenum target = 0;  ///< 0: reserved by GenTextures, not bound yet
        std::shared_ptr<TextureObject> object;
    };
    std::map<GLuint, Named> named;
    FreeNames free_names;
};

/// The target whose texture a unit has; none: it has none. [GL13] 3.8.15
inline std::optional<std::size_t> enabled_target(const TextureUnit& unit) {
    for (std::size_t target = texture_target_count; target-- > 0;)
        if (unit.enable[target]) return target;
    return std::nullopt;
}

/// The texture units of a context: the bound objects, and the images of the proxy targets.
struct BoundTextures {
    BoundTextures();
    using Objects = std::array<std::shared_ptr<TextureObject>, texture_target_count>;
    Objects initial;
    std::array<Objects, texture_unit_count> bound;
    std::array<TextureImages, texture_target_count> proxy;
};

/// The base format of an internal format; 0: there is none. [GL11] table
/// 3.16
GLenum base_format(GLint internal_format);

/// The compressed formats that programs are told of: those that suit every picture. [GL13] 3.8.1
inline constexpr std::array<GLenum, 3> compressed_texture_formats{GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
                                                                  GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
                                                                  GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};

/// Whether an internal format is compressed: one of blocks, or one for which the library may choose.
bool is_compressed(GLint internal_format);

/// Whether R, G, B of an internal format are encoded as in sRGB.
bool is_srgb(GLint internal_format);

/// Whether texels of an internal format are depths: R is the high half of 32 bits, G the low one. B
/// is the stencil value of those that have one.
inline bool is_depths(GLint internal_format) {
    const GLenum base = base_format(internal_format);
    return base == GL_DEPTH_COMPONENT || base == GL_DEPTH_STENCIL;
}
/// A depth as a texel.
constexpr Rgba depth_texel(std::uint32_t depth, std::uint32_t stencil = 0) {
    return {std::uint16_t(depth >> 16), std::uint16_t(depth & 0xFFFF), std::uint16_t(stencil), 0};
}

/// The channels that texels of an internal format have; of depths all.
TextureFormat machine_format(GLint internal_format);

/// Whether the base level can be drawn: of a cube six equal squares.
bool has_base(TextureObject& object, std::size_t target);

/// The machine's texture of an object, if its images fit each other and its filter; else null. A
/// profile without the extension texture_formats gets the first level as RGBA. It stays the same
/// texture until an image changes, whatever the filter is.
TextureRef machine_texture(TextureObject& object, std::size_t target, const Profile& profile);

}  // namespace gw::gl
