// The queries of texture environments, parameters and images. [GL11] 6.1.3, 6.1.4
#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/memory.h"
#include "gl/pixels/packed.h"
#include "gl/pixels/plain_pixels.h"
#include "gl/pixels/transfer.h"
#include "gl/query/values.h"
#include "gl/state/texture_targets.h"
#include "gw/base/to_bytes.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

namespace gw::gl {

namespace {

std::optional<QueryValues> tex_env_values(const Context& context, GLenum target, GLenum pname) {
    const TextureUnit& s = context.state.texture.unit();
    if (target == GL_POINT_SPRITE && pname == GL_COORD_REPLACE)
        return whole(context.state.point.coord_replace[context.state.texture.active]);
    if (target == GL_TEXTURE_FILTER_CONTROL && pname == GL_TEXTURE_LOD_BIAS)
        return number(s.lod_bias);
    if (target != GL_TEXTURE_ENV) return std::nullopt;
    switch (pname) {
        case GL_TEXTURE_ENV_MODE: return whole(s.env_mode);
        case GL_TEXTURE_ENV_COLOR: return units(s.env_color);
        case GL_COMBINE_RGB: return whole(s.combine_rgb.func);
        case GL_COMBINE_ALPHA: return whole(s.combine_alpha.func);
        case GL_RGB_SCALE: return number(s.combine_rgb.scale);
        case GL_ALPHA_SCALE: return number(s.combine_alpha.scale);
    }
    const std::size_t i = pname & 3;
    if (pname >= GL_SOURCE0_RGB && pname <= GL_SOURCE2_RGB) return whole(s.combine_rgb.source[i]);
    if (pname >= GL_SOURCE0_ALPHA && pname <= GL_SOURCE2_ALPHA)
        return whole(s.combine_alpha.source[i]);
    if (pname >= GL_OPERAND0_RGB && pname <= GL_OPERAND2_RGB)
        return whole(s.combine_rgb.operand[i]);
    if (pname >= GL_OPERAND0_ALPHA && pname <= GL_OPERAND2_ALPHA)
        return whole(s.combine_alpha.operand[i]);
    return std::nullopt;
}

std::optional<QueryValues> tex_gen_values(const Context& context, GLenum coord, GLenum pname) {
    if (coord < GL_S || coord > GL_Q) return std::nullopt;
    const TexGenState& s = context.state.texture.unit().gen[coord - GL_S];
    if (pname == GL_TEXTURE_GEN_MODE) return whole(s.mode);
    if (pname == GL_OBJECT_PLANE) return numbers_of(s.object_plane);
    if (pname == GL_EYE_PLANE) return numbers_of(s.eye_plane);
    return std::nullopt;
}

std::optional<QueryValues> tex_parameter_values(const Context& context, GLenum target,
                                                GLenum pname) {
    const auto index = target_index(context.profile, target);
    if (!index) return std::nullopt;
    const TextureParameters& s = bound_texture(context, *index).parameters;
    switch (pname) {
        case GL_TEXTURE_MIN_FILTER: return whole(s.min_filter);
        case GL_TEXTURE_MAG_FILTER: return whole(s.mag_filter);
        case GL_TEXTURE_WRAP_S: return whole(s.wrap_s);
        case GL_TEXTURE_WRAP_T: return whole(s.wrap_t);
        case GL_TEXTURE_WRAP_R: return whole(s.wrap_r);
        case GL_DEPTH_TEXTURE_MODE: return whole(s.depth_mode);
        case GL_TEXTURE_COMPARE_MODE: return whole(s.compare_mode);
        case GL_TEXTURE_COMPARE_FUNC: return whole(s.compare_func);
        case GL_TEXTURE_BORDER_COLOR: return units(s.border_color);
        case GL_TEXTURE_PRIORITY: return unit_value(s.priority);
        case GL_TEXTURE_RESIDENT: return whole(GL_TRUE);
        case GL_GENERATE_MIPMAP: return whole(s.generate_mipmap);
        case GL_TEXTURE_MIN_LOD: return number(s.min_lod);
        case GL_TEXTURE_MAX_LOD: return number(s.max_lod);
        case GL_TEXTURE_LOD_BIAS: return number(s.lod_bias);
        case GL_TEXTURE_BASE_LEVEL: return whole(s.base_level);
        case GL_TEXTURE_MAX_LEVEL: return whole(s.max_level);
    }
    return std::nullopt;
}

/// Alphas of blocks have less bits than texels.
int alpha_bits(const Context& context, GLint internal_format) {
    switch (internal_format) {
        case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT:
        case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT: return 1;
        case GL_COMPRESSED_RGBA_S3TC_DXT3_EXT:
        case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT: return 4;
    }
    return texel_bits(context.profile);
}

/// The bits that the machine keeps of a component that the format has.
int component_bits(const Context& context, const TextureImage& image, GLenum pname) {
    const GLenum base = image.width == 0 ? 0 : base_format(image.internal_format);
    const bool has_color = base == GL_RGB || base == GL_RGBA;
    const bool has_alpha = base == GL_RGBA || base == GL_ALPHA || base == GL_LUMINANCE_ALPHA;
    const bool has_luminance = base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA;
    const bool has = pname == GL_TEXTURE_ALPHA_SIZE       ? has_alpha
                     : pname == GL_TEXTURE_LUMINANCE_SIZE ? has_luminance
                     : pname == GL_TEXTURE_INTENSITY_SIZE ? base == GL_INTENSITY
                                                          : has_color;
    if (pname == GL_TEXTURE_DEPTH_SIZE)
        return is_depths(image.internal_format) ? context.profile.depth_bits : 0;
    if (pname == GL_TEXTURE_STENCIL_SIZE)
        return base == GL_DEPTH_STENCIL ? context.profile.stencil_bits : 0;
    if (has && pname == GL_TEXTURE_ALPHA_SIZE) return alpha_bits(context, image.internal_format);
    return has ? texel_bits(context.profile) : 0;
}

const TextureImage& level_image(const Context& context, const ImagePlace& place, GLint level) {
    const auto at = std::size_t(level);
    return place.is_proxy ? context.textures.proxy[place.index][at]
                          : bound_texture(context, place.index).image({place.face, at});
}

std::optional<QueryValues> tex_level_values(const Context& context, const ImagePlace& place,
                                            GLint level, GLenum pname) {
    const TextureImage& image = level_image(context, place, level);
    switch (pname) {
        case GL_TEXTURE_WIDTH: return whole(image.width);
        case GL_TEXTURE_HEIGHT: return whole(image.height);
        case GL_TEXTURE_DEPTH: return whole(image.width == 0 ? 0 : image.depth);
        case GL_TEXTURE_BORDER: return whole(image.border);
        case GL_TEXTURE_INTERNAL_FORMAT: return whole(image.internal_format);
        case GL_TEXTURE_COMPRESSED: return whole(image.blocks != nullptr);
        case GL_TEXTURE_COMPRESSED_IMAGE_SIZE: return whole(image.blocks->size());
        case GL_TEXTURE_RED_SIZE:
        case GL_TEXTURE_GREEN_SIZE:
        case GL_TEXTURE_BLUE_SIZE:
        case GL_TEXTURE_ALPHA_SIZE:
        case GL_TEXTURE_LUMINANCE_SIZE:
        case GL_TEXTURE_INTENSITY_SIZE:
        case GL_TEXTURE_STENCIL_SIZE:
        case GL_TEXTURE_DEPTH_SIZE: return whole(component_bits(context, image, pname));
    }
    return std::nullopt;
}

template <class T>
void get_tex_level(Context& context, GLenum target, GLint level, GLenum pname, T* params) {
    const auto place = place_of(context.profile, target);
    if (!place) return set_error(context, GL_INVALID_ENUM);
    if (!has_level(place->index, level)) return set_error(context, GL_INVALID_VALUE);
    if (pname == GL_TEXTURE_COMPRESSED_IMAGE_SIZE && !level_image(context, *place, level).blocks)
        return set_error(context, GL_INVALID_OPERATION);
    get(context, tex_level_values(context, *place, level, pname), params);
}

/// [GL11] 6.1.4: the channels that the format has, the others 0, and alpha 1.
class FormatChannels {
public:
    explicit FormatChannels(GLint internal_format) {
        const GLenum base = base_format(internal_format);
        const bool is_luminance =
            base == GL_INTENSITY || base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA;
        if (base == GL_ALPHA) keep_[0] = 0;
        if (base == GL_ALPHA || is_luminance) keep_[1] = keep_[2] = 0;
        if (base == GL_RGB || base == GL_INTENSITY || base == GL_LUMINANCE) {
            keep_[3] = 0;
            added_[3] = 0xFFFF;
        }
    }
    bool keep_all() const { return keep_ == Rgba{0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}; }
    Rgba of(const TextureImage& image, std::size_t i) const {
        std::uint64_t texel;
        std::memcpy(&texel, &image.texels[4 * i], sizeof texel);
        texel &= std::bit_cast<std::uint64_t>(keep_);
        texel |= std::bit_cast<std::uint64_t>(added_);
        Rgba out;
        std::memcpy(&out, &texel, sizeof out);
        return out;
    }

private:
    Rgba keep_{0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}, added_{};
};

/// Texels as bytes of a format. Empty: pack_words() does not know it.
std::vector<std::byte> texel_bytes(const TextureImage& image, GLenum format) {
    const FormatChannels channels(image.internal_format);
    std::vector<std::uint32_t> words(image.texels.size() / 4);
    auto* const bytes = reinterpret_cast<std::uint8_t*>(words.data());
    if (channels.keep_all()) {
        rescale_to_bytes(image.texels, bytes);
    } else {
        std::vector<Rgba> texels(words.size());
        for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = channels.of(image, i);
        rescale_to_bytes({texels.data()->data(), 4 * texels.size()}, bytes);
    }
    std::vector<std::byte> out(words.size() * std::size_t(component_count(format)));
    if (!pack_words(words, format, out.data())) out.clear();
    return out;
}

/// [GL11] 6.1.4: no pixel transfer. Luminance is R, not the sum that ReadPixels makes.
std::vector<std::byte> packed_texels(const TextureImage& image, GLenum format, GLenum type) {
    const bool is_luminance = format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA;
    if (const auto plain = as_bytes(format, type);
        plain.type == GL_UNSIGNED_BYTE && !is_luminance) {
        std::vector<std::byte> bytes = texel_bytes(image, plain.format);
        if (!bytes.empty()) return bytes;
    }
    const FormatChannels channels(image.internal_format);
    std::vector<vec4> colors;
    const std::size_t count = image.texels.size() / 4;
    colors.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Rgba texel = channels.of(image, i);
        const auto channel = [&](std::size_t k) { return float(texel[k]) / 65535; };
        colors.push_back(is_luminance ? vec4{channel(0), 0, 0, channel(3)}
                                      : vec4{channel(0), channel(1), channel(2), channel(3)});
    }
    return packed_colors(colors, format, type);
}

std::vector<double> depths_of(const TextureImage& image) {
    std::vector<double> out;
    for (std::size_t i = 0; i < image.texels.size(); i += 4)
        out.push_back((double(image.texels[i]) * 65536 + double(image.texels[i + 1])) /
                      4294967295.0);
    return out;
}

DepthsAndStencils pairs_of(const TextureImage& image) {
    DepthsAndStencils out{depths_of(image), {}};
    for (std::size_t i = 0; i < image.texels.size(); i += 4)
        out.stencils.push_back(image.texels[i + 2]);
    return out;
}

}  // namespace

namespace execute {

void get_tex_envfv(Context& context, GLenum target, GLenum pname, GLfloat* params) {
    get(context, tex_env_values(context, target, pname), params);
}
void get_tex_enviv(Context& context, GLenum target, GLenum pname, GLint* params) {
    get(context, tex_env_values(context, target, pname), params);
}
void get_tex_gendv(Context& context, GLenum coord, GLenum pname, GLdouble* params) {
    get(context, tex_gen_values(context, coord, pname), params);
}
void get_tex_genfv(Context& context, GLenum coord, GLenum pname, GLfloat* params) {
    get(context, tex_gen_values(context, coord, pname), params);
}
void get_tex_geniv(Context& context, GLenum coord, GLenum pname, GLint* params) {
    get(context, tex_gen_values(context, coord, pname), params);
}
void get_tex_parameterfv(Context& context, GLenum target, GLenum pname, GLfloat* params) {
    get(context, tex_parameter_values(context, target, pname), params);
}
void get_tex_parameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    get(context, tex_parameter_values(context, target, pname), params);
}
void get_tex_level_parameterfv(Context& context, GLenum target, GLint level, GLenum pname,
                               GLfloat* params) {
    get_tex_level(context, target, level, pname, params);
}
void get_tex_level_parameteriv(Context& context, GLenum target, GLint level, GLenum pname,
                               GLint* params) {
    get_tex_level(context, target, level, pname, params);
}

void get_tex_image(Context& context, GLenum target, GLint level, GLenum format, GLenum type,
                   GLvoid* pixels) {
    const auto place = place_of(context.profile, target);
    const bool is_pair = format == GL_DEPTH_STENCIL;
    const bool is_depth =
        (format == GL_DEPTH_COMPONENT || is_pair) && context.profile.extensions.texture_depth;
    if (!place || place->is_proxy || (!is_texel_format(format) && !is_depth) ||
        format == GL_COLOR_INDEX)
        return set_error(context, GL_INVALID_ENUM);
    if (!has_level(place->index, level)) return set_error(context, GL_INVALID_VALUE);
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    TextureObject& object = bound_texture(context, place->index);
    flush_mesh(context);
    update_texels(context, object);
    TextureImage& image = object.image({place->face, std::size_t(level)});
    if (image.width == 0) return;
    image.fill();
    if (is_depths(image.internal_format) != is_depth ||
        (is_pair && base_format(image.internal_format) != GL_DEPTH_STENCIL))
        return set_error(context, GL_INVALID_OPERATION);
    const std::vector<std::byte> rows =
        is_pair    ? packed_depths_and_stencils(pairs_of(image))
        : is_depth ? packed_values(depths_of(image), image.width, format, type)
                   : packed_texels(image, format, type);
    copy_slices_to_memory(context, context.client.pack, {image.width, image.height, image.depth},
                          place->index == three_dimensions, format, type, pixels, rows);
}

void get_compressed_tex_image(Context& context, GLenum target, GLint level, GLvoid* memory) {
    const auto place = place_of(context.profile, target);
    if (!place || place->is_proxy) return set_error(context, GL_INVALID_ENUM);
    if (!has_level(place->index, level)) return set_error(context, GL_INVALID_VALUE);
    const auto blocks = level_image(context, *place, level).blocks;
    if (!blocks) return set_error(context, GL_INVALID_OPERATION);
    std::byte* const at = values_memory(context, context.client.pack, blocks->size(), 1, memory);
    if (at != nullptr) std::ranges::copy(*blocks, at);
}

}  // namespace execute

}  // namespace gw::gl
