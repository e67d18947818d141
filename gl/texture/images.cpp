// TexImage, TexSubImage and the copies from the drawable. [GL11] 3.8.1, 3.8.2
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/read.h"
#include "gl/pixels/transfer.h"
#include "gl/texture/image_places.h"

#include "gw/base/arithmetic.h"
#include "gw/texture.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::gl {

namespace {

void tex_image(Context& context, GLenum target, const ImageRequest& r, GLenum format, GLenum type,
               const HostImage& host) {
    const auto place = place_of(target);
    if (!place) return set_error(context, GL_INVALID_ENUM);
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    if (!is_texel_format(format)) return set_error(context, GL_INVALID_ENUM);
    const GLenum error = request_error(context, r, place->index);
    if (place->is_proxy) return set_proxy(context, *place, r, error);
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (host.is_refused) return;
    TextureImage image = black_image(r);
    if (host.is_given())
        store_host_rgba(context, r.width, r.height, format, type, host, texel_bits,
                        colors_of(image));
    set_image(context, *place, r.level, std::move(image));
}

void tex_sub_image(Context& context, GLenum target, GLint level, const Rect& rect, GLenum format,
                   GLenum type, const HostImage& host) {
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    if (!is_texel_format(format)) return set_error(context, GL_INVALID_ENUM);
    const std::optional<ReplacedPart> part = replaced_part(context, target, level, rect);
    if (!part || !host.is_given()) return;
    replace(context, *part,
            host_rgba(context, rect.width, rect.height, format, type, host, texel_bits));
}

/// The drawable's pixels after transfer.
std::vector<Rgba> copied_colors(Context& context, const Rect& rect) {
    flush_mesh(context);
    return read_rgba(context, rect, Cause::Copy, texel_bits);
}

void copy_image(Context& context, GLenum target, const ImageRequest& r, GLint x, GLint y) {
    const auto index = target_index(target);
    if (!index) return set_error(context, GL_INVALID_ENUM);
    // [GL11] 3.8.2: the formats 1 to 4 are not among those of copies.
    if (r.internal_format >= 1 && r.internal_format <= 4)
        return set_error(context, GL_INVALID_ENUM);
    const GLenum error = request_error(context, r, *index);
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (context.read_drawable == nullptr) return;
    TextureImage image = black_image(r);
    std::ranges::copy(copied_colors(context, {x, y, r.width, r.height}), colors_of(image).begin());
    set_image(context, {*index, false}, r.level, std::move(image));
}

void copy_part(Context& context, GLenum target, GLint level, const Rect& rect, GLint x, GLint y) {
    const std::optional<ReplacedPart> part = replaced_part(context, target, level, rect);
    if (!part || context.read_drawable == nullptr || rect.area() == 0) return;
    replace(context, *part, copied_colors(context, {x, y, rect.width, rect.height}));
}

}  // namespace

namespace execute {

void tex_image_1d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLint border, GLenum format, GLenum type, const HostImage& image) {
    if (target != GL_TEXTURE_1D && target != GL_PROXY_TEXTURE_1D)
        return set_error(context, GL_INVALID_ENUM);
    tex_image(context, target, {level, internal_format, width, 1, border}, format, type, image);
}

void tex_image_2d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
                  const HostImage& image) {
    if (target != GL_TEXTURE_2D && target != GL_PROXY_TEXTURE_2D)
        return set_error(context, GL_INVALID_ENUM);
    tex_image(context, target, {level, internal_format, width, height, border}, format, type,
              image);
}

void tex_sub_image_1d(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width,
                      GLenum format, GLenum type, const HostImage& image) {
    if (target != GL_TEXTURE_1D) return set_error(context, GL_INVALID_ENUM);
    tex_sub_image(context, target, level, {xoffset, 0, width, 1}, format, type, image);
}

void tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                      GLsizei width, GLsizei height, GLenum format, GLenum type,
                      const HostImage& image) {
    if (target != GL_TEXTURE_2D) return set_error(context, GL_INVALID_ENUM);
    tex_sub_image(context, target, level, {xoffset, yoffset, width, height}, format, type, image);
}

void copy_tex_image_1d(Context& context, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLint border) {
    if (target != GL_TEXTURE_1D) return set_error(context, GL_INVALID_ENUM);
    copy_image(context, target, {level, GLint(internal_format), width, 1, border}, x, y);
}

void copy_tex_image_2d(Context& context, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLsizei height, GLint border) {
    if (target != GL_TEXTURE_2D) return set_error(context, GL_INVALID_ENUM);
    copy_image(context, target, {level, GLint(internal_format), width, height, border}, x, y);
}

void copy_tex_sub_image_1d(Context& context, GLenum target, GLint level, GLint xoffset, GLint x,
                           GLint y, GLsizei width) {
    if (target != GL_TEXTURE_1D) return set_error(context, GL_INVALID_ENUM);
    copy_part(context, target, level, {xoffset, 0, width, 1}, x, y);
}

void copy_tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (target != GL_TEXTURE_2D) return set_error(context, GL_INVALID_ENUM);
    copy_part(context, target, level, {xoffset, yoffset, width, height}, x, y);
}

}  // namespace execute

}  // namespace gw::gl
