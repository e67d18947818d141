// Texture objects: parameters and images, and the machine's texture that they make. [GL11] 3.8
#pragma once

#include "gl/state/state.h"
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
/// The largest side of a profile's textures.
constexpr int largest_texture(const Profile& p) {
    return p.extensions.texture_sizes ? max_texture_side : max_texture_size;
}

/// One level's image. Channels that the base format lacks are those of complete().
struct TextureImage {
    int width = 0, height = 0;  ///< with the border; 0: no image
    int border = 0;
    GLint internal_format = 1;  ///< as it was given
    TexelValues texels;         ///< 4 a texel, 0 .. 65535 is 0 .. 1, bottom row first
    /// As they were given compressed; null: they were not, or a part was replaced since.
    std::shared_ptr<const std::vector<std::byte>> blocks;
};

/// The machine's textures share the images' texels. So they are changed in place as long as no
/// frame draws with them.
struct TextureObject {
    TextureParameters parameters;
    std::array<TextureImage, level_count> levels;
    TextureHistory history;         ///< of `made`; parts of images that change belong to it
    bool changed = true;            ///< an image, since `made`
    bool made_with_levels = false;  ///< `made` has all levels, for filters that use them
    TextureRef made;                ///< null: there is no image
    int made_base = 0;              ///< the level that is its first
    std::size_t new_bytes = 0;      ///< of texels that were stored beside those that frames keep

    void set_image(std::size_t level, TextureImage image);
    /// Sets base_level or max_level: other levels belong to `made`.
    void set_level(int TextureParameters::*which, int level);
    /// The image of the base level.
    const TextureImage& base() const {
        return levels[std::size_t(std::min(parameters.base_level, level_count - 1))];
    }
    /// Makes the levels after the base level of it. [GL14] 3.8.8
    void generate_levels();
    /// Whether a part of a level can be replaced where it is: nobody else has the texels.
    bool is_alone(std::size_t level) const;
    /// `colors` are those of a rectangle, which counts from the border.
    void replace_part(std::size_t level, const Rect& rect, std::span<const Rgba> colors);
};

/// The index of a target: GL_TEXTURE_1D 0, GL_TEXTURE_2D 1.
std::optional<std::size_t> target_index(GLenum target);

/// The names of textures, and the objects. Contexts may share them. Name 0 has an object for each
/// target, of each context's own.
struct TextureNames {
    struct Named {
        GLenum target = 0;  ///< 0: reserved by GenTextures, not bound yet
        std::shared_ptr<TextureObject> object;
    };
    std::map<GLuint, Named> named;
};

/// The texture units of a context: the bound objects, and the images of the proxy targets.
struct BoundTextures {
    BoundTextures();
    std::array<std::shared_ptr<TextureObject>, texture_target_count> initial, bound;
    std::array<std::array<TextureImage, level_count>, texture_target_count> proxy;
};

/// The base format's number 1 to 4, or name, of an internal format; 0: there is none. [GL11] table
/// 3.16
GLenum base_format(GLint internal_format);

/// The compressed formats that programs are told of: those that suit every picture. [GL13] 3.8.1
inline constexpr std::array<GLenum, 3> compressed_texture_formats{GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
                                                                  GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
                                                                  GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};

/// Whether R, G, B of an internal format are encoded as in sRGB.
bool is_srgb(GLint internal_format);

/// The channels that texels of an internal format have.
TextureFormat machine_format(GLint internal_format);

/// The machine's texture of an object, if its images fit each other and its filter; else null. A
/// profile without the extension texture_formats gets the first level as RGBA. It stays the same
/// texture until an image changes, whatever the filter is.
TextureRef machine_texture(TextureObject& object, std::size_t target, const Profile& profile);

}  // namespace gw::gl
