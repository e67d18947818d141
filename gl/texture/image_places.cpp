#include "gl/texture/image_places.h"

#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include <bit>

namespace gw::gl {

namespace {

bool fits_level(const Profile& profile, int size, int border, int level) {
    const int inner = size - 2 * border;
    const bool is_any = profile.extensions.texture_sizes || std::has_single_bit(unsigned(inner));
    return size == 0 || (inner > 0 && is_any && inner <= largest_texture(profile) >> level);
}

/// Whether OpenGL has such a request, whatever the machine's limits are.
bool is_legal(const Context& context, const ImageRequest& r) {
    if (is_srgb(r.internal_format) && !context.profile.extensions.texture_srgb) return false;
    return base_format(r.internal_format) != 0 && r.level >= 0 && r.level < level_count &&
           (r.border == 0 || r.border == 1) && r.width >= 0 && r.height >= 0;
}

/// GL_GENERATE_MIPMAP: an image of the base level makes the others.
void generate_after(TextureObject& object, std::size_t level) {
    const TextureParameters& p = object.parameters;
    if (p.generate_mipmap && int(level) == p.base_level) object.generate_levels();
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

}  // namespace

std::optional<ImagePlace> place_of(GLenum target) {
    if (target == GL_PROXY_TEXTURE_1D) return ImagePlace{0, true};
    if (target == GL_PROXY_TEXTURE_2D) return ImagePlace{1, true};
    const auto index = target_index(target);
    return index ? std::optional(ImagePlace{*index, false}) : std::nullopt;
}

GLenum request_error(const Context& context, const ImageRequest& r, std::size_t target) {
    if (!is_legal(context, r)) return GL_INVALID_VALUE;
    const Profile& p = context.profile;
    const bool fits = fits_level(p, r.width, r.border, r.level) &&
                      (target == 0 || fits_level(p, r.height, r.border, r.level));
    return fits ? GL_NO_ERROR : GL_INVALID_VALUE;
}

TextureImage black_image(const ImageRequest& r) {
    if (r.width == 0 || r.height == 0) return {.internal_format = r.internal_format};
    const std::size_t texels = std::size_t(r.width) * std::size_t(r.height);
    return {r.width, r.height, r.border, r.internal_format, std::vector<std::uint16_t>(4 * texels),
            nullptr};
}

std::span<Rgba> colors_of(TextureImage& image) {
    std::vector<std::uint16_t>& values = image.texels.edit();
    return {reinterpret_cast<Rgba*>(values.data()), values.size() / 4};
}

void set_image(Context& context, const ImagePlace& place, GLint level, TextureImage image) {
    begin_change(context);
    complete(machine_format(image.internal_format), image.texels.edit());
    const auto lock = context.shared->exclusive();
    TextureObject& object = *context.textures.bound[place.index];
    object.set_image(std::size_t(level), std::move(image));
    generate_after(object, std::size_t(level));
}

void set_proxy(Context& context, const ImagePlace& place, const ImageRequest& r, GLenum error) {
    if (!is_legal(context, r)) return set_error(context, GL_INVALID_VALUE);
    TextureImage& image = context.textures.proxy[place.index][std::size_t(r.level)];
    image = error != GL_NO_ERROR
                ? TextureImage{.internal_format = 0}
                : TextureImage{r.width, r.height, r.border, r.internal_format, {}, nullptr};
}

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

void replace(Context& context, const ReplacedPart& part, std::span<const Rgba> colors) {
    if (part.rect.area() == 0) return;
    begin_change(context);
    release_texels(context, part);
    const auto lock = context.shared->exclusive();
    part.object.replace_part(part.level, part.rect, colors);
    generate_after(part.object, part.level);
}

}  // namespace gw::gl
