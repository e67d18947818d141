// GetBooleanv .. GetString, and the queries of lights, materials and textures. [GL11] 6.1
#include "gl/api/calls.h"
#include "gl/attributes/attributes.h"
#include "gl/context/context.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/memory.h"
#include "gl/pixels/transfer.h"
#include "gl/query/strings.h"
#include "gl/query/values.h"
#include "gl/state/evaluators.h"

#include <algorithm>
#include <optional>

namespace gw::gl {

namespace {

template <class T>
void get(Context& context, const std::optional<QueryValues>& values, T* params) {
    if (!values) return set_error(context, GL_INVALID_ENUM);
    if (params != nullptr) store(*values, params);
}

std::optional<QueryValues> light_values(const Context& context, GLenum light, GLenum pname) {
    if (light < GL_LIGHT0 || light >= GL_LIGHT0 + GLenum(light_count)) return std::nullopt;
    const LightState& s = context.state.lighting.lights[light - GL_LIGHT0];
    switch (pname) {
        case GL_AMBIENT: return units(s.ambient);
        case GL_DIFFUSE: return units(s.diffuse);
        case GL_SPECULAR: return units(s.specular);
        case GL_POSITION: return numbers_of(s.position);
        case GL_SPOT_DIRECTION: return numbers_of(s.spot_direction);
        case GL_SPOT_EXPONENT: return number(s.spot_exponent);
        case GL_SPOT_CUTOFF: return number(s.spot_cutoff);
        case GL_CONSTANT_ATTENUATION: return number(s.constant_attenuation);
        case GL_LINEAR_ATTENUATION: return number(s.linear_attenuation);
        case GL_QUADRATIC_ATTENUATION: return number(s.quadratic_attenuation);
    }
    return std::nullopt;
}

std::optional<QueryValues> material_values(Context& context, GLenum face, GLenum pname) {
    if (face != GL_FRONT && face != GL_BACK) return std::nullopt;
    track_color(context);
    const MaterialState& s = context.state.lighting.material[face == GL_BACK ? 1 : 0];
    switch (pname) {
        case GL_AMBIENT: return units(s.ambient);
        case GL_DIFFUSE: return units(s.diffuse);
        case GL_SPECULAR: return units(s.specular);
        case GL_EMISSION: return units(s.emission);
        case GL_SHININESS: return number(s.shininess);
        case GL_COLOR_INDEXES: return numbers_of(s.indexes);
    }
    return std::nullopt;
}

std::optional<QueryValues> tex_env_values(const Context& context, GLenum target, GLenum pname) {
    const TextureState& s = context.state.texture;
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
    const TexGenState& s = context.state.texture.gen[coord - GL_S];
    if (pname == GL_TEXTURE_GEN_MODE) return whole(s.mode);
    if (pname == GL_OBJECT_PLANE) return numbers_of(s.object_plane);
    if (pname == GL_EYE_PLANE) return numbers_of(s.eye_plane);
    return std::nullopt;
}

std::optional<QueryValues> tex_parameter_values(const Context& context, GLenum target,
                                                GLenum pname) {
    const auto index = target_index(target);
    if (!index) return std::nullopt;
    const TextureParameters& s = context.textures.bound[*index]->parameters;
    switch (pname) {
        case GL_TEXTURE_MIN_FILTER: return whole(s.min_filter);
        case GL_TEXTURE_MAG_FILTER: return whole(s.mag_filter);
        case GL_TEXTURE_WRAP_S: return whole(s.wrap_s);
        case GL_TEXTURE_WRAP_T: return whole(s.wrap_t);
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
    return has ? texel_bits(context.profile) : 0;
}

const TextureImage& level_image(const Context& context, GLenum target, GLint level) {
    const bool is_proxy = target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D;
    const std::size_t index = target == GL_TEXTURE_2D || target == GL_PROXY_TEXTURE_2D ? 1 : 0;
    const auto at = std::size_t(level);
    return is_proxy ? context.textures.proxy[index][at] : context.textures.bound[index]->levels[at];
}

std::optional<QueryValues> tex_level_values(const Context& context, GLenum target, GLint level,
                                            GLenum pname) {
    const TextureImage& image = level_image(context, target, level);
    switch (pname) {
        case GL_TEXTURE_WIDTH: return whole(image.width);
        case GL_TEXTURE_HEIGHT: return whole(image.height);
        case GL_TEXTURE_BORDER: return whole(image.border);
        case GL_TEXTURE_INTERNAL_FORMAT: return whole(image.internal_format);
        case GL_TEXTURE_COMPRESSED: return whole(image.blocks != nullptr);
        case GL_TEXTURE_COMPRESSED_IMAGE_SIZE:
            if (!image.blocks) return std::nullopt;
            return whole(image.blocks->size());
        case GL_TEXTURE_RED_SIZE:
        case GL_TEXTURE_GREEN_SIZE:
        case GL_TEXTURE_BLUE_SIZE:
        case GL_TEXTURE_ALPHA_SIZE:
        case GL_TEXTURE_LUMINANCE_SIZE:
        case GL_TEXTURE_INTENSITY_SIZE: return whole(component_bits(context, image, pname));
    }
    return std::nullopt;
}

template <class T>
void get_tex_level(Context& context, GLenum target, GLint level, GLenum pname, T* params) {
    const bool known = target_index(target).has_value() || target == GL_PROXY_TEXTURE_1D ||
                       target == GL_PROXY_TEXTURE_2D;
    if (!known) return set_error(context, GL_INVALID_ENUM);
    if (level < 0 || level >= level_count) return set_error(context, GL_INVALID_VALUE);
    get(context, tex_level_values(context, target, level, pname), params);
}

/// [GL11] 6.1.4: the channels that the format has, the others 0, and alpha 1.
vec4 texel_color(const TextureImage& image, std::size_t i) {
    const auto channel = [&](std::size_t k) { return float(image.texels[4 * i + k]) / 65535; };
    switch (base_format(image.internal_format)) {
        case GL_ALPHA: return {0, 0, 0, channel(3)};
        case GL_INTENSITY:
        case GL_LUMINANCE: return {channel(0), 0, 0, 1};
        case GL_LUMINANCE_ALPHA: return {channel(0), 0, 0, channel(3)};
        case GL_RGB: return {channel(0), channel(1), channel(2), 1};
    }
    return {channel(0), channel(1), channel(2), channel(3)};
}

template <class T>
void get_pixel_map(Context& context, GLenum map, T* values) {
    if (map < GL_PIXEL_MAP_I_TO_I || map > GL_PIXEL_MAP_A_TO_A)
        return set_error(context, GL_INVALID_ENUM);
    const bool is_index = map == GL_PIXEL_MAP_I_TO_I || map == GL_PIXEL_MAP_S_TO_S;
    const GLenum type = std::is_same_v<T, GLfloat>    ? GL_FLOAT
                        : std::is_same_v<T, GLushort> ? GL_UNSIGNED_SHORT
                                                      : GL_UNSIGNED_INT;
    const auto& table = context.pixel_maps[map];
    std::byte* at = values_memory(context, context.client.pack, table.size(), sizeof(T), values);
    if (at == nullptr) return;
    for (const float v : table) {
        store_component(type, at, double(v), is_index);
        at += sizeof(T);
    }
}

template <class T>
void get_map(Context& context, GLenum target, GLenum query, T* v) {
    const int size = map_size(target);
    if (size == 0) return set_error(context, GL_INVALID_ENUM);
    const bool two = target >= GL_MAP2_COLOR_4;
    const Map1& m1 = context.evaluators.map1[two ? 0 : target - GL_MAP1_COLOR_4];
    const Map2& m2 = context.evaluators.map2[two ? target - GL_MAP2_COLOR_4 : 0];
    std::vector<double> out;
    switch (query) {
        case GL_COEFF: out = two ? m2.points : m1.points; break;
        case GL_ORDER:
            out = two ? std::vector<double>{double(m2.uorder), double(m2.vorder)}
                      : std::vector<double>{double(m1.order)};
            break;
        case GL_DOMAIN:
            out = two ? std::vector<double>{m2.u1, m2.u2, m2.v1, m2.v2}
                      : std::vector<double>{m1.u1, m1.u2};
            break;
        default: return set_error(context, GL_INVALID_ENUM);
    }
    for (const double value : out) store(number(value), v++);
}

}  // namespace

namespace execute {

void get_booleanv(Context& context, GLenum pname, GLboolean* params) {
    get(context, state_variable(context, pname), params);
}
void get_integerv(Context& context, GLenum pname, GLint* params) {
    get(context, state_variable(context, pname), params);
}
void get_floatv(Context& context, GLenum pname, GLfloat* params) {
    get(context, state_variable(context, pname), params);
}
void get_doublev(Context& context, GLenum pname, GLdouble* params) {
    get(context, state_variable(context, pname), params);
}

GLenum get_error(Context& context) { return std::exchange(context.error, GLenum(GL_NO_ERROR)); }

const GLubyte* get_string(Context& context, GLenum name) {
    const char* const text = implementation_string(context.profile, name);
    if (text == nullptr) set_error(context, GL_INVALID_ENUM);
    return reinterpret_cast<const GLubyte*>(text);
}

void get_clip_plane(Context& context, GLenum plane, GLdouble* equation) {
    if (plane < GL_CLIP_PLANE0 || plane > GL_CLIP_PLANE5)
        return set_error(context, GL_INVALID_ENUM);
    get(context, numbers_of(context.state.transform.clip_plane[plane - GL_CLIP_PLANE0]), equation);
}

void get_lightfv(Context& context, GLenum light, GLenum pname, GLfloat* params) {
    get(context, light_values(context, light, pname), params);
}
void get_lightiv(Context& context, GLenum light, GLenum pname, GLint* params) {
    get(context, light_values(context, light, pname), params);
}
void get_materialfv(Context& context, GLenum face, GLenum pname, GLfloat* params) {
    get(context, material_values(context, face, pname), params);
}
void get_materialiv(Context& context, GLenum face, GLenum pname, GLint* params) {
    get(context, material_values(context, face, pname), params);
}
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
    const auto index = target_index(target);
    if (!index || !is_texel_format(format) || format == GL_COLOR_INDEX)
        return set_error(context, GL_INVALID_ENUM);
    if (level < 0 || level >= level_count) return set_error(context, GL_INVALID_VALUE);
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    const TextureImage& image = context.textures.bound[*index]->levels[std::size_t(level)];
    if (image.width == 0) return;
    pixels =
        image_memory(context, context.client.pack, image.width, image.height, format, type, pixels);
    if (pixels == nullptr) return;
    // [GL11] 6.1.4: no pixel transfer. Luminance is R, not the sum that ReadPixels makes.
    const bool is_luminance = format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA;
    std::vector<vec4> colors;
    const std::size_t count = image.texels.size() / 4;
    colors.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const vec4 texel = texel_color(image, i);
        colors.push_back(is_luminance ? vec4{texel.x, 0, 0, texel.w} : texel);
    }
    copy_to_memory(pixels, context.client.pack, image.width, image.height, format, type,
                   packed_colors(colors, format, type));
}

void get_compressed_tex_image(Context& context, GLenum target, GLint level, GLvoid* memory) {
    const auto index = target_index(target);
    if (!index) return set_error(context, GL_INVALID_ENUM);
    if (level < 0 || level >= level_count) return set_error(context, GL_INVALID_VALUE);
    const auto blocks = context.textures.bound[*index]->levels[std::size_t(level)].blocks;
    if (!blocks) return set_error(context, GL_INVALID_OPERATION);
    std::byte* const at = values_memory(context, context.client.pack, blocks->size(), 1, memory);
    if (at != nullptr) std::ranges::copy(*blocks, at);
}

void get_pixel_mapfv(Context& context, GLenum map, GLfloat* values) {
    get_pixel_map(context, map, values);
}
void get_pixel_mapuiv(Context& context, GLenum map, GLuint* values) {
    get_pixel_map(context, map, values);
}
void get_pixel_mapusv(Context& context, GLenum map, GLushort* values) {
    get_pixel_map(context, map, values);
}

void get_mapdv(Context& context, GLenum target, GLenum query, GLdouble* v) {
    get_map(context, target, query, v);
}
void get_mapfv(Context& context, GLenum target, GLenum query, GLfloat* v) {
    get_map(context, target, query, v);
}
void get_mapiv(Context& context, GLenum target, GLenum query, GLint* v) {
    get_map(context, target, query, v);
}

void get_polygon_stipple(Context& context, GLubyte* mask) {
    auto* const memory =
        image_memory(context, context.client.pack, 32, 32, GL_COLOR_INDEX, GL_BITMAP, mask);
    if (memory == nullptr) return;
    std::array<std::byte, 128> rows;
    rows.fill(std::byte{0xFF});
    if (const auto& pattern = context.state.polygon_stipple.pattern)
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i] = std::byte((*pattern)[i / 4] >> (24 - 8 * (i % 4)) & 0xFF);
    copy_to_memory(memory, context.client.pack, 32, 32, GL_COLOR_INDEX, GL_BITMAP, rows);
}

void get_pointerv(Context& context, GLenum pname, GLvoid** params) {
    const auto pointer = [&](Array a) {
        *params = const_cast<unsigned char*>(context.client.array(a).pointer);
    };
    if (params == nullptr) return;
    switch (pname) {
        case GL_VERTEX_ARRAY_POINTER: return pointer(Array::Vertex);
        case GL_NORMAL_ARRAY_POINTER: return pointer(Array::Normal);
        case GL_COLOR_ARRAY_POINTER: return pointer(Array::Color);
        case GL_SECONDARY_COLOR_ARRAY_POINTER: return pointer(Array::SecondaryColor);
        case GL_FOG_COORDINATE_ARRAY_POINTER: return pointer(Array::FogCoordinate);
        case GL_INDEX_ARRAY_POINTER: return pointer(Array::Index);
        case GL_TEXTURE_COORD_ARRAY_POINTER: return pointer(Array::TexCoord);
        case GL_EDGE_FLAG_ARRAY_POINTER: return pointer(Array::EdgeFlag);
        case GL_SELECTION_BUFFER_POINTER: *params = context.selection.hits; return;
        case GL_FEEDBACK_BUFFER_POINTER: *params = context.selection.feedback; return;
    }
    set_error(context, GL_INVALID_ENUM);
}

}  // namespace execute

}  // namespace gw::gl
