// Formats and types of pixels in the caller's memory. [GL11] tables 3.5 and 3.6
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <span>

namespace gw::gl {

/// The values of a pixel; 0: no such format.
int component_count(GLenum format);
/// The bytes of a value, or of a pixel whose type packs it; 0: no such type, or GL_BITMAP.
std::size_t component_bytes(GLenum type);
/// Whether a pixel is an index, not a colour or a depth.
inline bool is_index_format(GLenum format) {
    return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX;
}
/// Whether a pixel is a colour or an index of one: textures are made of such.
inline bool is_texel_format(GLenum format) {
    return component_count(format) > 0 && format != GL_STENCIL_INDEX &&
           format != GL_DEPTH_COMPONENT && format != GL_DEPTH_STENCIL;
}

/// The error of a format and type that do not fit each other, else GL_NO_ERROR. [GL11] 3.6.4
GLenum format_error(GLenum format, GLenum type);

/// The bytes of a row without padding.
std::size_t row_bytes(GLsizei width, GLenum format, GLenum type);

/// A value in the caller's memory; vertex arrays may have GL_DOUBLE too. Integers of colours and depths are 0 .. 1 or -1 .. 1.
double load_component(GLenum type, const std::byte* at, bool is_index);
/// Values side by side.
void load_components(GLenum type, const std::byte* at, std::span<double> values, bool is_index);
/// The reverse; clamped to what the type holds.
void store_component(GLenum type, std::byte* at, double value, bool is_index);
/// Values side by side.
void store_components(GLenum type, std::byte* at, std::span<const double> values, bool is_index);

}  // namespace gw::gl
