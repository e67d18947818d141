// TexImage, TexSubImage and the copies from the drawable. [GL11] 3.8.1, 3.8.2
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/read.h"
#include "gl/pixels/transfer.h"

#include "gw/base/arithmetic.h"
#include "gw/texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace gw::gl {

namespace {

/// An image's place: a bound object's level, or a proxy's.
struct ImagePlace {
    std::size_t index = 0;  ///< of the target
    bool is_proxy = false;
};

std::optional<ImagePlace> place_of(GLenum target) {
    if (target == GL_PROXY_TEXTURE_1D) return ImagePlace{0, true};
    if (target == GL_PROXY_TEXTURE_2D) return ImagePlace{1, true};
    const auto index = target_index(target);
    return index ? std::optional(ImagePlace{*index, false}) : std::nullopt;
}

bool fits_level(int size, int border, int level) {
    const int inner = size - 2 * border;
    return size == 0 || (inner > 0 && std::has_single_bit(unsigned(inner)) &&
                         inner <= max_texture_size >> level);
}

/// The size and format of an image.
struct Request {
    GLint level, internal_format;
    GLsizei width, height;
    GLint border;
};

/// Whether OpenGL has such a request, whatever the machine's limits are.
bool is_legal(const Request& r) {
    return base_format(r.internal_format) != 0 && r.level >= 0 && r.level < level_count &&
           (r.border == 0 || r.border == 1) && r.width >= 0 && r.height >= 0;
}

GLenum request_error(const Request& r, std::size_t target) {
    if (!is_legal(r)) return GL_INVALID_VALUE;
    const bool fits = fits_level(r.width, r.border, r.level) &&
                      (target == 0 || fits_level(r.height, r.border, r.level));
    return fits ? GL_NO_ERROR : GL_INVALID_VALUE;
}

/// Texels keep 16 bits a channel.
constexpr int texel_bits = 16;

/// The image of a request, all texels 0.
TextureImage black_image(const Request& r) {
    if (r.width == 0 || r.height == 0) return {.internal_format = r.internal_format};
    const std::size_t texels = std::size_t(r.width) * std::size_t(r.height);
    return {r.width, r.height, r.border, r.internal_format, std::vector<std::uint16_t>(4 * texels)};
}

/// The texels as colours.
std::span<Rgba> colors_of(TextureImage& image) {
    std::vector<std::uint16_t>& values = image.texels.edit();
    return {reinterpret_cast<Rgba*>(values.data()), values.size() / 4};
}

/// Replaces an image. `image` has all four channels, whatever the format keeps of them.
void set_image(Context& context, const ImagePlace& place, GLint level, TextureImage image) {
    begin_change(context);
    complete(machine_format(image.internal_format), image.texels.edit());
    const auto lock = context.shared->exclusive();
    context.textures.bound[place.index]->set_image(std::size_t(level), std::move(image));
}

/// [GL11] 3.8.6: only an image that cannot be supported makes the proxy 0; other errors are errors.
void set_proxy(Context& context, const ImagePlace& place, const Request& r, GLenum error) {
    if (!is_legal(r)) return set_error(context, GL_INVALID_VALUE);
    TextureImage& image = context.textures.proxy[place.index][std::size_t(r.level)];
    image = error != GL_NO_ERROR ? TextureImage{.internal_format = 0}
                                 : TextureImage{r.width, r.height, r.border, r.internal_format, {}};
}

void tex_image(Context& context, GLenum target, const Request& r, GLenum format, GLenum type,
               const HostImage& host) {
    const auto place = place_of(target);
    if (!place) return set_error(context, GL_INVALID_ENUM);
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    if (!is_texel_format(format)) return set_error(context, GL_INVALID_ENUM);
    const GLenum error = request_error(r, place->index);
    if (place->is_proxy) return set_proxy(context, *place, r, error);
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (host.is_refused) return;
    TextureImage image = black_image(r);
    if (host.is_given())
        store_host_rgba(context, r.width, r.height, format, type, host, texel_bits,
                        colors_of(image));
    set_image(context, *place, r.level, std::move(image));
}

/// The part of a bound object's level that a call replaces.
struct ReplacedPart {
    TextureObject& object;
    std::size_t level;
    Rect rect;  ///< counts from the border
};

/// None, and the error is set: there is no image, or the part is not inside it. Offsets count from
/// inside the border.
std::optional<ReplacedPart> replaced_part(Context& context, GLenum target, GLint level,
                                          const Rect& part) {
    const auto index = target_index(target);
    if (!index) return set_error(context, GL_INVALID_ENUM), std::nullopt;
    if (level < 0 || level >= level_count)
        return set_error(context, GL_INVALID_VALUE), std::nullopt;
    TextureObject& object = *context.textures.bound[*index];
    const TextureImage& image = object.levels[std::size_t(level)];
    if (image.width == 0) return set_error(context, GL_INVALID_OPERATION), std::nullopt;
    const auto inside = [&](std::int64_t at, std::int64_t size, int whole, int border) {
        return size >= 0 && at >= -border && at + size <= whole - border;
    };
    const int border_t = *index == 0 ? 0 : image.border;
    if (!inside(part.x, part.width, image.width, image.border) ||
        !inside(part.y, part.height, image.height, border_t))
        return set_error(context, GL_INVALID_VALUE), std::nullopt;
    return ReplacedPart{object,
                        std::size_t(level),
                        {part.x + image.border, part.y + border_t, part.width, part.height}};
}

/// A frame that draws with the texels keeps them as they are, so that they would be copied. If they
/// are many and the part is small, it costs less to execute the frame.
void release_texels(Context& context, const ReplacedPart& part) {
    constexpr std::size_t many = 512 * 512;
    const std::size_t texels = part.object.levels[part.level].texels.size() / 4;
    if (texels < many || 4 * part.rect.area() > texels || context.drawable == nullptr) return;
    {
        const auto lock = context.shared->exclusive();
        if (part.object.is_alone(part.level)) return;
    }
    context.drawable->flush(Cause::Texture);
}

void replace(Context& context, const ReplacedPart& part, const std::vector<Rgba>& colors) {
    if (part.rect.area() == 0) return;
    begin_change(context);
    release_texels(context, part);
    const auto lock = context.shared->exclusive();
    part.object.replace_part(part.level, part.rect, colors);
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

void copy_image(Context& context, GLenum target, const Request& r, GLint x, GLint y) {
    const auto index = target_index(target);
    if (!index) return set_error(context, GL_INVALID_ENUM);
    // [GL11] 3.8.2: the formats 1 to 4 are not among those of copies.
    if (r.internal_format >= 1 && r.internal_format <= 4)
        return set_error(context, GL_INVALID_ENUM);
    const GLenum error = request_error(r, *index);
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
