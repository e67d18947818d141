// TexImage, TexSubImage and the copies from the drawable. [GL11] 3.8.1, 3.8.2
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/read.h"
#include "gl/pixels/transfer.h"
#include "gl/texture/compressed.h"

#include "gw/base/arithmetic.h"
#include "gw/texture.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::gl {

namespace {

bool is_depth_format(GLenum format) {
    return format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL;
}

/// [GL14] 3.8.1, 3.8.2: depths become depths only, and colours colours.
bool fits_format(GLenum format, GLint internal_format) {
    return is_depth_format(format) == is_depths(internal_format);
}

/// Depths 0 .. 1 as texels, and stencil values if there are any.
void store_depths(const DepthsAndStencils& values, std::span<Rgba> out) {
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = depth_texel(quantize(values.depths[i], 32),
                             values.stencils.empty() ? 0 : values.stencils[i] & 0xFF);
}

/// The caller's pixels after transfer. `rows`: of all slices.
void store_texels(Context& context, GLsizei width, GLsizei rows, GLenum format, GLenum type,
                  const HostImage& host, std::span<Rgba> out) {
    if (format == GL_DEPTH_COMPONENT)
        return store_depths({host_depths(context, width, rows, type, host), {}}, out);
    if (format == GL_DEPTH_STENCIL)
        return store_depths(host_depths_and_stencils(context, width, rows, host), out);
    store_host_rgba(context, width, rows, format, type, host, texel_bits, out);
}

/// The error of a format and type of texels.
GLenum texel_error(const Context& context, GLenum format, GLenum type) {
    if (const GLenum error = format_error(format, type)) return error;
    const bool is_depth = is_depth_format(format) && context.profile.extensions.texture_depth;
    return is_texel_format(format) || is_depth ? GL_NO_ERROR : GL_INVALID_ENUM;
}

/// `dimensions`: of the call.
void tex_image(Context& context, GLenum target, int dimensions, ImageRequest r, GLenum format,
               GLenum type, const HostImage& host) {
    const auto place = place_of(context.profile, target);
    if (!place || dimensions_of(*place) != dimensions) return set_error(context, GL_INVALID_ENUM);
    r.internal_format = stored_format(r, *place);
    if (const GLenum error = texel_error(context, format, type)) return set_error(context, error);
    const GLenum error = request_error(context, r, *place);
    if (error == GL_NO_ERROR && !fits_format(format, r.internal_format))
        return set_error(context, GL_INVALID_OPERATION);
    if (place->is_proxy) return set_proxy(context, *place, r, error);
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (host.is_refused) return;
    TextureImage image = black_image(r);
    if (host.is_given())
        store_texels(context, r.width, r.height * r.depth, format, type, host, colors_of(image));
    compress(image);
    set_image(context, *place, r.level, std::move(image));
}

void tex_sub_image(Context& context, GLenum target, int dimensions, GLint level,
                   const TexelBox& box, GLenum format, GLenum type, const HostImage& host) {
    if (const GLenum error = texel_error(context, format, type)) return set_error(context, error);
    const auto part = replaced_part(context, target, dimensions, level, box);
    if (!part) return;
    if (!fits_format(format, part->image().internal_format))
        return set_error(context, GL_INVALID_OPERATION);
    if (!host.is_given()) return;
    std::vector<Rgba> texels(box.size());
    store_texels(context, box.rect.width, box.rect.height * box.slices, format, type, host, texels);
    replace_texels(context, *part, texels);
}

/// The drawable's pixels after transfer: colours, or depths for an image of them.
std::vector<Rgba> copied_texels(Context& context, const Rect& rect, GLint internal_format) {
    flush_mesh(context);
    if (!is_depths(internal_format)) return read_rgba(context, rect, Cause::Copy, texel_bits);
    DepthsAndStencils values{read_values(context, Plane::Depth, rect, Cause::Copy), {}};
    for (double& depth : values.depths) depth = transferred_depth(context, depth);
    if (base_format(internal_format) == GL_DEPTH_STENCIL)
        for (const double stencil : read_values(context, Plane::Stencil, rect, Cause::Copy))
            values.stencils.push_back(transferred_stencil(context, stencil));
    std::vector<Rgba> out(values.depths.size());
    store_depths(values, out);
    return out;
}

/// Whether what is read has the planes of an image of this format.
bool can_copy(Context& context, GLint internal_format) {
    const GLenum base = base_format(internal_format);
    if (!is_depths(internal_format)) return can_read(context, Plane::Color);
    return can_read(context, Plane::Depth) &&
           (base == GL_DEPTH_COMPONENT || can_read(context, Plane::Stencil));
}

void copy_image(Context& context, GLenum target, int dimensions, ImageRequest r, GLint x, GLint y) {
    const auto place = place_of(context.profile, target);
    if (!place || place->is_proxy || dimensions_of(*place) != dimensions)
        return set_error(context, GL_INVALID_ENUM);
    // [GL11] 3.8.2: the formats 1 to 4 are not among those of copies.
    if (r.internal_format >= 1 && r.internal_format <= 4)
        return set_error(context, GL_INVALID_ENUM);
    r.internal_format = stored_format(r, *place);
    const GLenum error = request_error(context, r, *place);
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (!can_copy(context, r.internal_format)) return;
    if (context.read_drawable == nullptr) return;
    TextureImage image = black_image(r);
    std::ranges::copy(copied_texels(context, {x, y, r.width, r.height}, r.internal_format),
                      colors_of(image).begin());
    compress(image);
    set_image(context, *place, r.level, std::move(image));
}

void copy_part(Context& context, GLenum target, int dimensions, GLint level, const TexelBox& box,
               GLint x, GLint y) {
    const auto part = replaced_part(context, target, dimensions, level, box);
    if (!part || !can_copy(context, part->image().internal_format)) return;
    if (context.read_drawable == nullptr || box.size() == 0) return;
    const Rect from{x, y, box.rect.width, box.rect.height};
    replace_texels(context, *part, copied_texels(context, from, part->image().internal_format));
}

}  // namespace

namespace execute {

void tex_image_1d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLint border, GLenum format, GLenum type, const HostImage& image) {
    tex_image(context, target, 1, {level, internal_format, width, 1, border}, format, type, image);
}

void tex_image_2d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
                  const HostImage& image) {
    tex_image(context, target, 2, {level, internal_format, width, height, border}, format, type,
              image);
}

void tex_image_3d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLsizei height, GLsizei depth, GLint border, GLenum format,
                  GLenum type, const HostImage& image) {
    tex_image(context, target, 3, {level, internal_format, width, height, border, depth}, format,
              type, image);
}

void tex_sub_image_1d(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width,
                      GLenum format, GLenum type, const HostImage& image) {
    tex_sub_image(context, target, 1, level, {{xoffset, 0, width, 1}}, format, type, image);
}

void tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                      GLsizei width, GLsizei height, GLenum format, GLenum type,
                      const HostImage& image) {
    tex_sub_image(context, target, 2, level, {{xoffset, yoffset, width, height}}, format, type,
                  image);
}

void tex_sub_image_3d(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                      GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format,
                      GLenum type, const HostImage& image) {
    tex_sub_image(context, target, 3, level, {{xoffset, yoffset, width, height}, zoffset, depth},
                  format, type, image);
}

void copy_tex_image_1d(Context& context, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLint border) {
    copy_image(context, target, 1, {level, GLint(internal_format), width, 1, border}, x, y);
}

void copy_tex_image_2d(Context& context, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLsizei height, GLint border) {
    copy_image(context, target, 2, {level, GLint(internal_format), width, height, border}, x, y);
}

void copy_tex_sub_image_1d(Context& context, GLenum target, GLint level, GLint xoffset, GLint x,
                           GLint y, GLsizei width) {
    copy_part(context, target, 1, level, {{xoffset, 0, width, 1}}, x, y);
}

void copy_tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
    copy_part(context, target, 2, level, {{xoffset, yoffset, width, height}}, x, y);
}

void copy_tex_sub_image_3d(Context& context, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width,
                           GLsizei height) {
    copy_part(context, target, 3, level, {{xoffset, yoffset, width, height}, zoffset}, x, y);
}

}  // namespace execute

}  // namespace gw::gl
