// GetBooleanv .. GetString, and the queries of lights and materials. [GL11] 6.1
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
        case GL_TEXTURE_COORD_ARRAY_POINTER:
            return pointer(texcoord_array(context.client.active_unit));
        case GL_EDGE_FLAG_ARRAY_POINTER: return pointer(Array::EdgeFlag);
        case GL_SELECTION_BUFFER_POINTER: *params = context.selection.hits; return;
        case GL_FEEDBACK_BUFFER_POINTER: *params = context.selection.feedback; return;
    }
    set_error(context, GL_INVALID_ENUM);
}

}  // namespace execute

}  // namespace gw::gl
