// Converts the arguments of entry points to the values that calls take. Reads pointers only as far
// as the counts and enumerations beside them say.
#pragma once

#include "gl/api/finite.h"
#include "gl/api/values.h"

#include <GL/gl.h>

#include <limits>
#include <type_traits>

namespace gw::gl {

/// [GL11] table 2.6: an integer colour component or normal as a number.
template <class T>
constexpr double unit(T c) {
    constexpr double largest = double(std::numeric_limits<T>::max());
    if constexpr (std::is_signed_v<T>) return (2.0 * double(c) + 1.0) / (2.0 * largest + 1.0);
    return double(c) / largest;
}

/// How many parameters `pname` has; 0: it is unknown.
int parameter_count(GLenum pname);
/// Whether integers of this parameter stand for 0 .. 1 (colours).
bool is_color_parameter(GLenum pname);

template <class T>
Params scalar(T param) {
    return {{finite(double(param))}, 1};
}
template <class T>
Params vector(GLenum pname, const T* params) {
    Params out{{}, parameter_count(pname)};
    for (int i = 0; i < out.count; ++i) {
        const bool is_unit = std::is_integral_v<T> && is_color_parameter(pname);
        out.value[std::size_t(i)] = is_unit ? unit(params[i]) : finite(double(params[i]));
    }
    return out;
}

template <class T>
dmat4 matrix(const T* m) {
    dmat4 out(0);
    for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = finite(double(m[i]));
    return out;
}

template <class T>
dmat4 transposed_matrix(const T* m) {
    dmat4 out(0);
    for (int i = 0; i < 16; ++i) out[i % 4][i / 4] = finite(double(m[i]));
    return out;
}

template <class T>
Numbers numbers(GLsizei n, const T* values) {
    if (n < 0 || values == nullptr) n = 0;
    return std::make_shared<const std::vector<double>>(values, values + n);
}

Stipple stipple(const GLubyte* mask);
constexpr bool is_proxy_target(GLenum target) {
    return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D ||
           target == GL_PROXY_TEXTURE_RECTANGLE || target == GL_PROXY_TEXTURE_3D ||
           target == GL_PROXY_TEXTURE_CUBE_MAP;
}
/// The pixels of a texture's image; a proxy has none.
inline const GLvoid* image_pixels(GLenum target, const GLvoid* pixels) {
    return is_proxy_target(target) ? nullptr : pixels;
}

/// A copy of an image in the caller's memory. None on an error: the memory of an ignored call is
/// not read.
HostImage unpack(GLsizei width, GLsizei height, GLenum format, GLenum type, const GLvoid* pixels);
/// The same for a texture's image. Sizes that no texture has are errors.
HostImage unpack_texture(GLsizei width, GLsizei height, GLenum format, GLenum type,
                         const GLvoid* pixels);
/// The same of three dimensions; the slices follow each other.
HostImage unpack_volume(GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
                        const GLvoid* pixels);
/// The blocks of a compressed image; none if `size` is not that of such an image.
HostImage compressed_blocks(GLenum format, GLsizei width, GLsizei height, GLsizei size,
                            const GLvoid* blocks);
/// The names that CallLists adds to the list base. [GL11] 5.4
Numbers list_names(GLsizei n, GLenum type, const GLvoid* lists);

/// A pixel map's values; integers stand for 0 .. 1, except in maps to indices.
Numbers map_values(GLenum map, GLsizei size, const GLfloat* values);
Numbers map_values(GLenum map, GLsizei size, const GLuint* values);
Numbers map_values(GLenum map, GLsizei size, const GLushort* values);

/// Control points without gaps, u before v; none if an argument is wrong. [GL11] 5.1
Numbers control_points(GLenum target, GLint stride, GLint order, const GLfloat* points);
Numbers control_points(GLenum target, GLint stride, GLint order, const GLdouble* points);
Numbers control_points(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                       const GLfloat* points);
Numbers control_points(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                       const GLdouble* points);

}  // namespace gw::gl
