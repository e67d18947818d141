#include "gl/pixels/formats.h"

#include "gl/api/convert.h"
#include "gl/pixels/packed.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace gw::gl {

namespace {

template <class T>
double load_as(const std::byte* at, bool is_index) {
    T value;
    std::memcpy(&value, at, sizeof value);
    if constexpr (std::is_integral_v<T>)
        if (!is_index) return unit(value);
    return double(value);
}

/// [GL11] table 4.7: the integer that stands for a number. Of an index the low bits, but for a sign
/// (table 4.6).
template <class T>
T integer_of(double value, bool is_index) {
    constexpr double low = double(std::numeric_limits<T>::min());
    constexpr double high = double(std::numeric_limits<T>::max());
    if (is_index) {
        const double nearest = std::clamp(value, -0x1p62, 0x1p62) + 0.5;
        const auto whole = static_cast<std::int64_t>(nearest);
        return T((whole - (double(whole) > nearest)) & std::int64_t{std::numeric_limits<T>::max()});
    }
    if constexpr (std::is_unsigned_v<T>) {
        const double nearest = value * high + 0.5;
        return nearest >= 0 ? T(std::min(nearest, high)) : T(0);  // a cast is a floor here
    }
    value = ((2 * high + 1) * value - 1) / 2;
    return std::isnan(value) ? T(0) : T(std::clamp(std::floor(value + 0.5), low, high));
}

template <class T>
void store_as(std::byte* at, double value, bool is_index) {
    T out;
    if constexpr (std::is_integral_v<T>)
        out = integer_of<T>(value, is_index);
    else
        out = T(value);
    std::memcpy(at, &out, sizeof out);
}

}  // namespace

int component_count(GLenum format) {
    switch (format) {
        case GL_COLOR_INDEX:
        case GL_STENCIL_INDEX:
        case GL_DEPTH_COMPONENT:
        case GL_RED:
        case GL_GREEN:
        case GL_BLUE:
        case GL_ALPHA:
        case GL_LUMINANCE: return 1;
        case GL_LUMINANCE_ALPHA:
        case GL_DEPTH_STENCIL: return 2;
        case GL_RGB:
        case GL_BGR: return 3;
        case GL_RGBA:
        case GL_BGRA:
        case GL_ABGR_EXT: return 4;
    }
    return 0;
}

std::size_t component_bytes(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE: return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT: return 2;
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT: return 4;
    }
    const PackedType* const packed = packed_type(type);
    return packed != nullptr ? packed->bytes : 0;
}

// A packed type and another format: GL_INVALID_OPERATION, whatever the format is, as on Mesa.
GLenum format_error(GLenum format, GLenum type) {
    if (const PackedType* const packed = packed_type(type))
        return is_packed_format(*packed, format) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    if (component_count(format) == 0 || format == GL_DEPTH_STENCIL) return GL_INVALID_ENUM;
    if (type == GL_BITMAP) return is_index_format(format) ? GL_NO_ERROR : GL_INVALID_ENUM;
    return component_bytes(type) == 0 ? GL_INVALID_ENUM : GL_NO_ERROR;
}

std::size_t row_bytes(GLsizei width, GLenum format, GLenum type) {
    if (type == GL_BITMAP) return (std::size_t(width) + 7) / 8;
    const std::size_t values =
        packed_type(type) != nullptr ? 1 : std::size_t(component_count(format));
    return std::size_t(width) * values * component_bytes(type);
}

void load_components(GLenum type, const std::byte* at, std::span<double> values, bool is_index) {
    const auto load = [&]<class T>(T) {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = load_as<T>(at + i * sizeof(T), is_index);
    };
    switch (type) {
        case GL_BYTE: return load(GLbyte());
        case GL_UNSIGNED_BYTE: return load(GLubyte());
        case GL_SHORT: return load(GLshort());
        case GL_UNSIGNED_SHORT: return load(GLushort());
        case GL_INT: return load(GLint());
        case GL_UNSIGNED_INT: return load(GLuint());
        case GL_FLOAT: return load(GLfloat());
        case GL_DOUBLE: return load(GLdouble());
    }
}

double load_component(GLenum type, const std::byte* at, bool is_index) {
    double value = 0;
    load_components(type, at, {&value, 1}, is_index);
    return value;
}

void store_components(GLenum type, std::byte* at, std::span<const double> values, bool is_index) {
    const auto store = [&]<class T>(T) {
        for (std::size_t i = 0; i < values.size(); ++i)
            store_as<T>(at + i * sizeof(T), values[i], is_index);
    };
    switch (type) {
        case GL_BYTE: return store(GLbyte());
        case GL_UNSIGNED_BYTE: return store(GLubyte());
        case GL_SHORT: return store(GLshort());
        case GL_UNSIGNED_SHORT: return store(GLushort());
        case GL_INT: return store(GLint());
        case GL_UNSIGNED_INT: return store(GLuint());
        case GL_FLOAT: return store(GLfloat());
    }
}

void store_component(GLenum type, std::byte* at, double value, bool is_index) {
    store_components(type, at, {&value, 1}, is_index);
}

}  // namespace gw::gl
