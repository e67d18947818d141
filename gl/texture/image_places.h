// Places and sizes of texture images, and their replacement: what TexImage, its copies and its
// compressed forms share. [GL11] 3.8.1, 3.8.2
#pragma once

#include "gl/state/texture_objects.h"

#include <optional>
#include <span>

namespace gw::gl {

struct Context;

/// An image's place: a bound object's level, or a proxy's.
struct ImagePlace {
    std::size_t index = 0;  ///< of the target
    bool is_proxy = false;
};
/// None: no such target.
std::optional<ImagePlace> place_of(GLenum target);

/// The size and format of an image.
struct ImageRequest {
    GLint level, internal_format;
    GLsizei width, height;
    GLint border;
};
/// NO_ERROR if the machine has such an image. `target`: its index.
GLenum request_error(const Context& context, const ImageRequest& r, std::size_t target);

/// Texels keep 16 bits a channel.
inline constexpr int texel_bits = 16;

/// The image of a request, all texels 0.
TextureImage black_image(const ImageRequest& r);
/// The texels as colours.
std::span<Rgba> colors_of(TextureImage& image);

/// Replaces an image. `image` has all four channels, whatever the format keeps of them.
void set_image(Context& context, const ImagePlace& place, GLint level, TextureImage image);
/// [GL11] 3.8.6: only an image that cannot be supported makes the proxy 0; other errors are errors.
void set_proxy(Context& context, const ImagePlace& place, const ImageRequest& r, GLenum error);

/// The part of a bound object's level that a call replaces.
struct ReplacedPart {
    TextureObject& object;
    std::size_t level;
    Rect rect;  ///< counts from the border
};
/// None, and the error is set: there is no image, or the part is not inside it. Offsets count from
/// inside the border.
std::optional<ReplacedPart> replaced_part(Context& context, GLenum target, GLint level,
                                          const Rect& part);
void replace(Context& context, const ReplacedPart& part, std::span<const Rgba> colors);

}  // namespace gw::gl
