#include "gl/texture/image_places.h"

#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

#include <bit>

namespace gw::gl {

namespace {

bool fits_level(const Profile& profile, std::size_t target, int size, int border, int level) {
    const int inner = size - 2 * border;
    const bool is_any = profile.extensions.texture_sizes || std::has_single_bit(unsigned(inner));
    return size == 0 || (inner > 0 && is_any && inner <= largest_texture(profile, target) >> level);
}

/// The error of a request that OpenGL does not have, whatever the machine's limits are.
GLenum illegal(const Context& context, const ImageRequest& r, std::size_t target) {
    const Extensions& has = context.profile.extensions;
    const bool has_format = base_format(r.internal_format) != 0 &&
                            (!is_srgb(r.internal_format) || has.texture_srgb) &&
                            (!is_depths(r.internal_format) || has.texture_depth);
    const int most_border = target == rectangular ? 0 : 1;
    if (!has_format || !has_level(target, r.level) || r.border < 0 || r.border > most_border ||
        r.width < 0 || r.height < 0 || r.depth < 0)
        return GL_INVALID_VALUE;
    // [GL14] 3.8.1
    const bool is_flat =
        target == one_dimension || target == two_dimensions || target == rectangular;
    return is_depths(r.internal_format) && !is_flat ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

/// GL_GENERATE_MIPMAP: an image of the base level makes the others.
void generate_after(TextureObject& object, const ImageKey& key) {
    const TextureParameters& p = object.parameters;
    if (p.generate_mipmap && int(key.level) == p.base_level) object.generate_levels(key.face);
}

/// A frame that draws with the texels keeps them as they are, so that they would be copied. If they
/// are many and the part is small, it costs less to execute the frame.
void release_texels(Context& context, const ReplacedPart& part) {
    constexpr std::size_t many = 512 * 512;
    const std::size_t texels = part.image().texels.size() / 4;
    if (texels < many || 4 * part.box.size() > texels || context.drawable == nullptr) return;
    {
        const auto lock = context.shared->exclusive();
        if (part.object.is_alone(part.key)) return;
    }
    context.drawable->flush(Cause::Texture);
}

}  // namespace

GLenum request_error(const Context& context, const ImageRequest& r, const ImagePlace& place) {
    if (const GLenum error = illegal(context, r, place.index)) return error;
    const auto fits = [&](int size, int border) {
        return fits_level(context.profile, place.index, size, border, r.level);
    };
    const bool fit = fits(r.width, r.border) &&
                     (place.index == one_dimension || fits(r.height, r.border)) &&
                     (place.index != three_dimensions || fits(r.depth, r.border)) &&
                     (place.index != cube || r.width == r.height);
    return fit ? GL_NO_ERROR : GL_INVALID_VALUE;
}

TextureImage black_image(const ImageRequest& r) {
    if (r.width == 0 || r.height == 0 || r.depth == 0)
        return {.internal_format = r.internal_format};
    return {r.width, r.height, r.border, r.internal_format, {}, nullptr, r.depth};
}

std::span<Rgba> colors_of(TextureImage& image) {
    image.fill();
    std::vector<std::uint16_t>& values = image.texels.edit();
    return {reinterpret_cast<Rgba*>(values.data()), values.size() / 4};
}

void set_image(Context& context, const ImagePlace& place, GLint level, TextureImage image) {
    begin_change(context);
    if (image.texels.size() != 0)
        complete(machine_format(image.internal_format), image.texels.edit());
    const auto lock = context.shared->exclusive();
    TextureObject& object = bound_texture(context, place.index);
    const ImageKey key{place.face, std::size_t(level)};
    object.set_image(key, std::move(image));
    generate_after(object, key);
}

void set_proxy(Context& context, const ImagePlace& place, const ImageRequest& r, GLenum error) {
    if (const GLenum wrong = illegal(context, r, place.index)) return set_error(context, wrong);
    TextureImage& image = context.textures.proxy[place.index][std::size_t(r.level)];
    image = error != GL_NO_ERROR ? TextureImage{.internal_format = 0, .depth = 0}
                                 : TextureImage{r.width, r.height, r.border, r.internal_format,
                                                {},      nullptr,  r.depth};
}

std::optional<ReplacedPart> replaced_part(Context& context, GLenum target, int dimensions,
                                          GLint level, const TexelBox& part) {
    const auto place = place_of(context.profile, target);
    if (!place || place->is_proxy || dimensions_of(*place) != dimensions)
        return set_error(context, GL_INVALID_ENUM), std::nullopt;
    if (!has_level(place->index, level)) return set_error(context, GL_INVALID_VALUE), std::nullopt;
    TextureObject& object = bound_texture(context, place->index);
    if (!object.rendered.empty()) {
        flush_mesh(context);
        update_texels(context, object);
    }
    const ImageKey key{place->face, std::size_t(level)};
    const TextureImage& image = object.image(key);
    if (image.width == 0) return set_error(context, GL_INVALID_OPERATION), std::nullopt;
    const auto inside = [&](std::int64_t at, std::int64_t size, int whole, int border) {
        return size >= 0 && at >= -border && at + size <= whole - border;
    };
    const int border_t = dimensions >= 2 ? image.border : 0;
    const int border_r = dimensions == 3 ? image.border : 0;
    const Rect& rect = part.rect;
    if (!inside(rect.x, rect.width, image.width, image.border) ||
        !inside(rect.y, rect.height, image.height, border_t) ||
        !inside(part.slice, part.slices, image.depth, border_r))
        return set_error(context, GL_INVALID_VALUE), std::nullopt;
    return ReplacedPart{object,
                        key,
                        {{rect.x + image.border, rect.y + border_t, rect.width, rect.height},
                         part.slice + border_r,
                         part.slices}};
}

void replace(Context& context, const ReplacedPart& part, std::span<const Rgba> colors) {
    if (part.box.size() == 0) return;
    begin_change(context);
    release_texels(context, part);
    const auto lock = context.shared->exclusive();
    part.object.replace_part(part.key, part.box, colors);
    generate_after(part.object, part.key);
}

}  // namespace gw::gl
