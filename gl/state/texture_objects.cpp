#include "gl/state/texture_objects.h"

#include <algorithm>

namespace gw::gl {

namespace {

bool uses_levels(const TextureParameters& p) {
    return p.min_filter != GL_NEAREST && p.min_filter != GL_LINEAR;
}

/// How many levels there are from the base level on, down to one texel or to the last level that may
/// be used, if all fit each other; else 0. [GL12] 3.8.8
int complete_levels(const TextureObject& object) {
    const TextureImage& first = object.base();
    const auto& [base, last] = std::pair(object.parameters.base_level, object.parameters.max_level);
    if (base > last || base >= level_count || first.width == 0) return 0;
    int width = first.width - 2 * first.border, height = first.height - 2 * first.border;
    if (first.height == 1) height = 1;  // one dimension
    int count = 1;
    for (; (width > 1 || height > 1) && base + count <= last; ++count) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        if (base + count >= level_count) return 0;
        const TextureImage& image = object.levels[std::size_t(base + count)];
        const bool flat = first.height == 1;
        if (image.internal_format != first.internal_format || image.border != first.border ||
            image.width != width + 2 * image.border ||
            image.height != (flat ? 1 : height + 2 * image.border))
            return 0;
    }
    return count;
}

/// For profiles with RGBA textures only: the first level without its border, its levels made by the
/// machine.
TextureRef plain_texture(const TextureImage& image) {
    const int border = image.border, width = image.width - 2 * border;
    const int height = image.height == 1 ? 1 : image.height - 2 * border;
    const int bottom = image.height == 1 ? 0 : border;
    std::vector<std::uint16_t> rgba;
    for (int y = 0; y < height; ++y) {
        const std::uint16_t* const row =
            &image.texels[4 * pixel_index(border, y + bottom, image.width)];
        rgba.insert(rgba.end(), row, row + 4 * width);
    }
    return make_texture("", width, height, rgba);
}

/// All levels if they fit each other; else the first one, for the filters that use no others.
void make(TextureObject& object, std::size_t target, const Profile& profile) {
    const TextureImage& first = object.base();
    const int count = complete_levels(object);
    object.made_with_levels = count > 0;
    object.made_base = std::min(object.parameters.base_level, level_count - 1);
    if (!profile.extensions.texture_formats ||
        (first.border && !profile.extensions.texture_border)) {
        object.made = plain_texture(first);
        return;
    }
    if (object.history.is_empty()) object.history = TextureHistory::begin();
    Texture texture{.format = machine_format(first.internal_format),
                    .dimensions = target == 0 ? 1 : 2,
                    .border = first.border != 0,
                    .srgb = is_srgb(first.internal_format),
                    .history = object.history};
    for (int level = 0; level < std::max(1, count); ++level) {
        const TextureImage& image = object.levels[std::size_t(object.made_base + level)];
        const int rows = target == 0 ? 1 : image.height - 2 * image.border;
        texture.levels.push_back({image.width - 2 * image.border, rows, image.texels});
    }
    object.made = share_texture(std::move(texture));
}

}  // namespace

std::optional<std::size_t> target_index(GLenum target) {
    if (target == GL_TEXTURE_1D) return 0;
    if (target == GL_TEXTURE_2D) return 1;
    return std::nullopt;
}

BoundTextures::BoundTextures() {
    for (auto& object : initial) object = std::make_shared<TextureObject>();
    bound = initial;
}

GLenum base_format(GLint internal_format) {
    switch (internal_format) {
        case 1:
        case GL_LUMINANCE:
        case GL_LUMINANCE4:
        case GL_LUMINANCE8:
        case GL_LUMINANCE12:
        case GL_LUMINANCE16:
        case GL_COMPRESSED_LUMINANCE:
        case GL_SLUMINANCE:
        case GL_SLUMINANCE8:
        case GL_COMPRESSED_SLUMINANCE: return GL_LUMINANCE;
        case 2:
        case GL_LUMINANCE_ALPHA:
        case GL_LUMINANCE4_ALPHA4:
        case GL_LUMINANCE6_ALPHA2:
        case GL_LUMINANCE8_ALPHA8:
        case GL_LUMINANCE12_ALPHA4:
        case GL_LUMINANCE12_ALPHA12:
        case GL_LUMINANCE16_ALPHA16:
        case GL_COMPRESSED_LUMINANCE_ALPHA:
        case GL_SLUMINANCE_ALPHA:
        case GL_SLUMINANCE8_ALPHA8:
        case GL_COMPRESSED_SLUMINANCE_ALPHA: return GL_LUMINANCE_ALPHA;
        case GL_ALPHA:
        case GL_ALPHA4:
        case GL_ALPHA8:
        case GL_ALPHA12:
        case GL_ALPHA16:
        case GL_COMPRESSED_ALPHA: return GL_ALPHA;
        case GL_INTENSITY:
        case GL_INTENSITY4:
        case GL_INTENSITY8:
        case GL_INTENSITY12:
        case GL_INTENSITY16:
        case GL_COMPRESSED_INTENSITY: return GL_INTENSITY;
        case 3:
        case GL_RGB:
        case GL_R3_G3_B2:
        case GL_RGB4:
        case GL_RGB5:
        case GL_RGB8:
        case GL_RGB10:
        case GL_RGB12:
        case GL_RGB16:
        case GL_COMPRESSED_RGB:
        case GL_COMPRESSED_RGB_S3TC_DXT1_EXT:
        case GL_SRGB:
        case GL_SRGB8:
        case GL_COMPRESSED_SRGB:
        case GL_COMPRESSED_SRGB_S3TC_DXT1_EXT: return GL_RGB;
        case 4:
        case GL_RGBA:
        case GL_RGBA2:
        case GL_RGBA4:
        case GL_RGB5_A1:
        case GL_RGBA8:
        case GL_RGB10_A2:
        case GL_RGBA12:
        case GL_RGBA16:
        case GL_COMPRESSED_RGBA:
        case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT:
        case GL_COMPRESSED_RGBA_S3TC_DXT3_EXT:
        case GL_COMPRESSED_RGBA_S3TC_DXT5_EXT:
        case GL_SRGB_ALPHA:
        case GL_SRGB8_ALPHA8:
        case GL_COMPRESSED_SRGB_ALPHA:
        case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT:
        case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT:
        case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT: return GL_RGBA;
    }
    return 0;
}

bool is_srgb(GLint internal_format) {
    return internal_format >= GL_SRGB && internal_format <= GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT;
}

TextureFormat machine_format(GLint internal_format) {
    switch (base_format(internal_format)) {
        case GL_ALPHA: return TextureFormat::Alpha;
        case GL_LUMINANCE: return TextureFormat::Luminance;
        case GL_LUMINANCE_ALPHA: return TextureFormat::LuminanceAlpha;
        case GL_INTENSITY: return TextureFormat::Intensity;
        case GL_RGB: return TextureFormat::RGB;
    }
    return TextureFormat::RGBA;
}

void TextureObject::set_image(std::size_t level, TextureImage image) {
    new_bytes += image.texels.size() * sizeof(std::uint16_t);
    levels[level] = std::move(image);
    history = {};
    changed = true;
}

bool TextureObject::is_alone(std::size_t level) const {
    return made ? gw::is_alone(made) : levels[level].texels.is_alone();
}

void TextureObject::replace_part(std::size_t level, const Rect& rect,
                                 std::span<const Rgba> colors) {
    const int made_count = made ? int(made->levels.size()) : level_count;
    made = nullptr;
    TextureImage& image = levels[level];
    if (!image.texels.is_alone()) new_bytes += image.texels.size() * sizeof(std::uint16_t);
    std::vector<std::uint16_t>& texels = image.texels.edit();
    const Rgba* from = colors.data();
    for (int y = rect.y; y < rect.y + rect.height; ++y, from += rect.width) {
        const std::span to(&texels[4 * pixel_index(rect.x, y, image.width)],
                           4 * std::size_t(rect.width));
        std::copy_n(from->data(), to.size(), to.data());
        complete(machine_format(image.internal_format), to);
    }
    image.blocks = nullptr;
    const int made_level = int(level) - made_base;
    const bool is_made = made_level >= 0 && made_level < made_count;
    if (!history.is_empty() && is_made) history.replace({made_level, rect});
    changed = true;
}

void TextureObject::set_level(int TextureParameters::*which, int level) {
    parameters.*which = level;
    history = {};
    changed = true;
}

void TextureObject::generate_levels() {
    const TextureImage first = base();
    if (first.width == 0 || first.border != 0) return;
    const TextureRef whole = make_whole_texture("", first.width, first.height, *first.texels,
                                                is_srgb(first.internal_format));
    for (std::size_t i = 1; i < whole->levels.size(); ++i) {
        const int level = parameters.base_level + int(i);
        if (level >= level_count || level > parameters.max_level) return;
        const TextureLevel& made_level = whole->levels[i];
        set_image(std::size_t(level), {made_level.width, made_level.height, 0,
                                       first.internal_format, made_level.rgba, nullptr});
    }
}

TextureRef machine_texture(TextureObject& object, std::size_t target, const Profile& profile) {
    if (object.changed) {
        object.made = nullptr;
        if (object.base().width > 0) make(object, target, profile);
        object.changed = false;
    }
    return object.made_with_levels || !uses_levels(object.parameters) ? object.made : nullptr;
}

}  // namespace gw::gl
