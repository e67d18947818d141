// Texture objects: parameters and images, and the machine's texture that they make. [GL11] 3.8
#pragma once

#include "gl/state/state.h"
#include "gw/profile.h"
#include "gw/texture.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace gw::gl {

/// 4096 = 2^12.
inline constexpr int level_count = 13;

/// One level's image. Channels that the base format lacks are those of complete().
struct TextureImage {
    int width = 0, height = 0;  ///< with the border; 0: no image
    int border = 0;
    GLint internal_format = 1;  ///< as it was given
    TexelValues texels;         ///< 4 a texel, 0 .. 65535 is 0 .. 1, bottom row first
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
    std::size_t new_bytes = 0;      ///< of texels that were stored beside those that frames keep

    void set_image(std::size_t level, TextureImage image);
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

/// The channels that texels of an internal format have.
TextureFormat machine_format(GLint internal_format);

/// The machine's texture of an object, if its images fit each other and its filter; else null. A
/// profile without the extension texture_formats gets the first level as RGBA. It stays the same
/// texture until an image changes, whatever the filter is.
TextureRef machine_texture(TextureObject& object, std::size_t target, const Profile& profile);

}  // namespace gw::gl
