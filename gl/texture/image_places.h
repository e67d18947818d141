// Places and sizes of texture images, and their replacement: what TexImage, its copies and its
// compressed forms share. [GL11] 3.8.1, 3.8.2
#pragma once

#include "gl/state/texture_targets.h"

#include <optional>
#include <span>

namespace gw::gl {

struct Context;

/// The size and format of an image.
struct ImageRequest {
    GLint level, internal_format;
    GLsizei width, height;
    GLint border;
    GLsizei depth = 1;
};
/// NO_ERROR if the machine has such an image.
GLenum request_error(const Context& context, const ImageRequest& r, const ImagePlace& place);

/// Texels keep 16 bits a channel.
inline constexpr int texel_bits = 16;

/// The image of a request, without texels yet.
TextureImage black_image(const ImageRequest& r);
/// The texels as colours.
std::span<Rgba> colors_of(TextureImage& image);

/// Replaces an image. `image` has all four channels, whatever the format keeps of them.
void set_image(Context& context, const ImagePlace& place, GLint level, TextureImage image);
/// [GL11] 3.8.6: only an image that cannot be supported makes the proxy 0; other errors are errors.
void set_proxy(Context& context, const ImagePlace& place, const ImageRequest& r, GLenum error);

/// The part of a bound object's image that a call replaces.
struct ReplacedPart {
    TextureObject& object;
    ImageKey key;
    TexelBox box;  ///< counts from the border
    TextureImage& image() const { return object.image(key); }
};
/// None, and the error is set: there is no image, or the part is not inside it. Offsets count from
/// inside the border. `dimensions`: of the call.
std::optional<ReplacedPart> replaced_part(Context& context, GLenum target, int dimensions,
                                          GLint level, const TexelBox& part);
void replace(Context& context, const ReplacedPart& part, std::span<const Rgba> colors);

}  // namespace gw::gl
