#include "gl/state/texture_objects.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <utility>

namespace gw::gl {

namespace {

bool uses_levels(const TextureParameters& p) {
    return p.min_filter != GL_NEAREST && p.min_filter != GL_LINEAR;
}

/// The inner size of an image on a level.
struct Extent {
    int width, height, depth;
    bool operator==(const Extent&) const = default;
    bool has_next() const { return width > 1 || height > 1 || depth > 1; }
    Extent next() const {
        return {std::max(1, width / 2), std::max(1, height / 2), std::max(1, depth / 2)};
    }
};
Extent inner(const TextureImage& image, std::size_t target) {
    const int both = 2 * image.border;
    return {image.width - both, target == one_dimension ? 1 : image.height - both,
            target == three_dimensions ? image.depth - both : 1};
}

/// Whether all faces of a level have this size, and the format of the first image.
bool fits(TextureObject& object, std::size_t target, std::size_t level, const Extent& size) {
    const TextureImage& first = object.base();
    for (std::size_t face = 0; face <= object.further_faces.size(); ++face) {
        const TextureImage& image = object.image({face, level});
        if (image.internal_format != first.internal_format || image.border != first.border ||
            image.width == 0 || inner(image, target) != size)
            return false;
    }
    return true;
}

/// How many levels there are from the base level on, down to one texel or to the last level that may
/// be used, if all fit each other; else 0. [GL12] 3.8.8, [GL13] 3.8.10
int complete_levels(TextureObject& object, std::size_t target) {
    const TextureImage& first = object.base();
    const auto& [base, last] = std::pair(object.parameters.base_level, object.parameters.max_level);
    if (base > last || base >= level_count || first.width == 0) return 0;
    Extent size = inner(first, target);
    int count = 1;
    for (; size.has_next() && base + count <= last; ++count) {
        size = size.next();
        if (base + count >= level_count) return 0;
        if (!fits(object, target, std::size_t(base + count), size)) return 0;
    }
    return count;
}

void warn_of_border(const TextureImage& image) {
    static std::atomic_flag warned;
    if (warned.test_and_set()) return;
    std::fprintf(stderr,
                 "gw: warning: texture image of %d x %d x %d texels: the machine draws three "
                 "dimensions, cubes and depths without a border; it is left out\n",
                 image.width, image.height, image.depth);
}

/// The texels without the border.
std::vector<std::uint16_t> inner_texels(const TextureImage& image, std::size_t target) {
    const Extent size = inner(image, target);
    const int left = image.border, bottom = target == one_dimension ? 0 : image.border;
    const int first = target == three_dimensions ? image.border : 0;
    std::vector<std::uint16_t> out;
    for (int z = first; z < first + size.depth; ++z)
        for (int y = bottom; y < bottom + size.height; ++y) {
            const std::uint16_t* const row =
                &image.texels[4 * pixel_index(left, z * image.height + y, image.width)];
            out.insert(out.end(), row, row + 4 * size.width);
        }
    return out;
}

/// For profiles with RGBA textures only: the first level without its border, its levels made by the
/// machine.
TextureRef plain_texture(const TextureImage& image, std::size_t target) {
    const Extent size = inner(image, target);
    return make_texture("", size.width, size.height, inner_texels(image, target));
}

/// The format of what is looked up.
TextureFormat format_of(const TextureObject& object) {
    if (!is_depths(object.base().internal_format))
        return machine_format(object.base().internal_format);
    return machine_format(GLint(object.parameters.depth_mode));
}

/// One level of the machine's texture: of a cube its faces one after the other.
TextureLevel machine_level(TextureObject& object, std::size_t target, std::size_t level,
                           bool has_border) {
    const TextureImage& first = object.levels[level];
    const Extent size = inner(first, target);
    const bool strips = first.border != 0 && !has_border;
    const int layers = target == cube ? 6 : size.depth;
    if (!strips && target != cube) return {size.width, size.height, first.texels, layers};
    std::vector<std::uint16_t> all;
    for (std::size_t face = 0; face <= object.further_faces.size(); ++face) {
        const std::vector<std::uint16_t> texels = inner_texels(object.image({face, level}), target);
        all.insert(all.end(), texels.begin(), texels.end());
    }
    return {size.width, size.height, std::move(all), layers};
}

/// All levels if they fit each other; else the first one, for the filters that use no others.
void make(TextureObject& object, std::size_t target, const Profile& profile) {
    const int count = complete_levels(object, target);
    for (int level = 0; level < std::max(1, count); ++level)
        for (std::size_t face = 0; face <= object.further_faces.size(); ++face)
            object.image({face, object.base_level() + std::size_t(level)}).fill();
    const TextureImage& first = object.base();
    object.made_with_levels = count > 0;
    object.made_base = int(object.base_level());
    if (!profile.extensions.texture_formats ||
        (first.border && !profile.extensions.texture_border)) {
        object.made = plain_texture(first, target);
        return;
    }
    Texture texture{.format = format_of(object),
                    .dimensions = target == one_dimension      ? 1
                                  : target == three_dimensions ? 3
                                                               : 2,
                    .srgb = is_srgb(first.internal_format),
                    .cube = target == cube,
                    .depths = is_depths(first.internal_format)};
    texture.border = first.border != 0 && !needs_r(texture);
    if (first.border != 0 && !texture.border) warn_of_border(first);
    if (object.history.is_empty()) object.history = TextureHistory::begin();
    texture.history = object.history;
    for (int level = 0; level < std::max(1, count); ++level)
        texture.levels.push_back(
            machine_level(object, target, std::size_t(object.made_base + level), texture.border));
    object.made = share_texture(std::move(texture));
}

}  // namespace

bool has_base(TextureObject& object, std::size_t target) {
    const TextureImage& first = object.base();
    if (first.width == 0) return false;
    if (target != cube) return true;
    return first.width == first.height &&
           fits(object, target, object.base_level(), inner(first, target));
}

std::optional<std::size_t> target_index(const Profile& profile, GLenum target) {
    for (std::size_t i = 0; i < texture_target_count; ++i)
        if (texture_targets[i] == target && has_target(profile, i)) return i;
    return std::nullopt;
}

std::shared_ptr<TextureObject> new_texture(std::size_t target) {
    auto object = std::make_shared<TextureObject>();
    if (target == cube) object->further_faces.resize(5);
    if (target == rectangular) {
        TextureParameters& p = object->parameters;
        p.min_filter = GL_LINEAR;
        p.wrap_s = p.wrap_t = p.wrap_r = GL_CLAMP_TO_EDGE;
    }
    return object;
}

BoundTextures::BoundTextures() {
    for (std::size_t target = 0; target < texture_target_count; ++target)
        initial[target] = new_texture(target);
    bound.fill(initial);
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
        case GL_DEPTH_COMPONENT:
        case GL_DEPTH_COMPONENT16:
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32: return GL_DEPTH_COMPONENT;
        case GL_DEPTH_STENCIL:
        case GL_DEPTH24_STENCIL8: return GL_DEPTH_STENCIL;
    }
    return 0;
}

bool is_compressed(GLint internal_format) {
    const auto is_in = [internal_format](GLint first, GLint last) {
        return internal_format >= first && internal_format <= last;
    };
    return is_in(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT) ||
           is_in(GL_COMPRESSED_ALPHA, GL_COMPRESSED_RGBA) ||
           is_in(GL_COMPRESSED_SRGB, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT);
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

void TextureImage::fill() {
    if (texels.size() != 0 || width == 0) return;
    std::vector<std::uint16_t> all(4 * pixel_index(0, height * depth, width));
    complete(machine_format(internal_format), all);
    texels = std::move(all);
}

void TextureObject::set_image(const ImageKey& key, TextureImage given) {
    std::erase_if(rendered, [&](const auto& entry) { return entry.first.key == key; });
    new_bytes += given.texels.size() * sizeof(std::uint16_t);
    image(key) = std::move(given);
    history = {};
    changed = true;
}

void TextureObject::set_parameters(const TextureParameters& all) {
    const TextureParameters before = std::exchange(parameters, all);
    if (before.base_level == all.base_level && before.max_level == all.max_level &&
        before.depth_mode == all.depth_mode)
        return;
    history = {};  // other levels, or another format
    changed = true;
}

bool TextureObject::is_alone(const ImageKey& key) {
    return made && further_faces.empty() ? gw::is_alone(made) : image(key).texels.is_alone();
}

void TextureObject::replace_part(const ImageKey& key, const TexelBox& box,
                                 std::span<const Rgba> colors) {
    const int made_count = made ? int(made->levels.size()) : level_count;
    made = nullptr;
    TextureImage& in = image(key);
    in.fill();
    for (auto& [place, plane] : rendered)
        if (place.key == key) plane.older = surface_planes;
    if (!in.texels.is_alone()) new_bytes += in.texels.size() * sizeof(std::uint16_t);
    std::vector<std::uint16_t>& texels = in.texels.edit();
    const Rgba* from = colors.data();
    const Rect& rect = box.rect;
    for (int z = box.slice; z < box.slice + box.slices; ++z)
        for (int y = rect.y; y < rect.y + rect.height; ++y, from += rect.width) {
            const std::span to(&texels[4 * pixel_index(rect.x, z * in.height + y, in.width)],
                               4 * std::size_t(rect.width));
            std::copy_n(from->data(), to.size(), to.data());
            complete(machine_format(in.internal_format), to);
        }
    in.blocks = nullptr;
    const int made_level = int(key.level) - made_base;
    const bool is_made = made_level >= 0 && made_level < made_count;
    if (!further_faces.empty() || in.depth > 1 || is_depths(in.internal_format))
        history = {};  // parts of such textures are not told
    else if (!history.is_empty() && is_made)
        history.replace({made_level, rect});
    changed = true;
}

namespace {

/// The next level of depths: means of four.
TextureLevel next_depths(const TextureLevel& level) {
    TextureLevel out{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
    const auto depth = [&](int x, int y) {
        const std::size_t at = 4 * pixel_index(std::min(x, level.width - 1),
                                               std::min(y, level.height - 1), level.width);
        return std::uint64_t(level.rgba[at]) << 16 | level.rgba[at + 1];
    };
    std::vector<std::uint16_t>& texels = out.rgba.edit();
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const std::uint64_t sum = depth(2 * x, 2 * y) + depth(2 * x + 1, 2 * y) +
                                      depth(2 * x, 2 * y + 1) + depth(2 * x + 1, 2 * y + 1);
            const Rgba texel = depth_texel(std::uint32_t((sum + 2) / 4));
            texels.insert(texels.end(), texel.begin(), texel.end());
        }
    return out;
}

/// The levels after an image, of one face.
std::vector<TextureLevel> levels_after(const TextureImage& image) {
    std::vector<TextureLevel> out;
    if (image.depth == 1 && !is_depths(image.internal_format)) {
        const TextureRef whole = make_whole_texture("", image.width, image.height, *image.texels);
        return {whole->levels.begin() + 1, whole->levels.end()};
    }
    TextureLevel level{image.width, image.height, image.texels, image.depth};
    while (level.width > 1 || level.height > 1 || level.layers > 1) {
        level = is_depths(image.internal_format) ? next_depths(level) : next_level(level, 3);
        out.push_back(level);
    }
    return out;
}

}  // namespace

void TextureObject::generate_levels(std::size_t face) {
    image({face, base_level()}).fill();
    const TextureImage first = image({face, base_level()});
    if (first.width == 0 || first.border != 0) return;
    int level = parameters.base_level;
    for (const TextureLevel& next : levels_after(first)) {
        if (++level >= level_count || level > parameters.max_level) return;
        set_image({face, std::size_t(level)}, {next.width, next.height, 0, first.internal_format,
                                               next.rgba, nullptr, next.layers});
    }
}

TextureRef machine_texture(TextureObject& object, std::size_t target, const Profile& profile) {
    if (object.changed) {
        object.made = nullptr;
        if (has_base(object, target)) make(object, target, profile);
        object.changed = false;
    }
    return object.made_with_levels || !uses_levels(object.parameters) ? object.made : nullptr;
}

}  // namespace gw::gl
