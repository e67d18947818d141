// Pixel transfer: the host's values become colours, depths and indices, and vice versa. [GL11]
// 3.6.3 to 3.6.5
#pragma once

#include "gl/api/values.h"
#include "gw/base/types.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gw::gl {

struct Context;
struct PixelState;

/// Whether transfer leaves colours in 0 .. 1 as they are.
bool leaves_colors(const PixelState& s);
/// Whether it leaves stencil values as they are.
bool leaves_stencils(const PixelState& s);
/// Scale, bias and the maps from colours to colours; clamped to 0 .. 1.
vec4 transferred_color(const Context& context, vec4 color);
double transferred_depth(const Context& context, double depth);
/// Shift, offset and the map from stencil values to stencil values.
GLuint transferred_stencil(const Context& context, double index);

/// The pixels of an image after transfer, quantized to `bits` bits. Colour indices become colours.
std::vector<Rgba> host_rgba(const Context& context, GLsizei width, GLsizei height, GLenum format,
                            GLenum type, const HostImage& image, int bits);
/// The same into `out`, which has as many pixels.
void store_host_rgba(const Context& context, GLsizei width, GLsizei height, GLenum format,
                     GLenum type, const HostImage& image, int bits, std::span<Rgba> out);
std::vector<double> host_depths(const Context& context, GLsizei width, GLsizei height, GLenum type,
                                const HostImage& image);
std::vector<GLuint> host_stencils(const Context& context, GLsizei width, GLsizei height,
                                  GLenum type, const HostImage& image);

struct DepthsAndStencils {
    std::vector<double> depths;
    std::vector<GLuint> stencils;
};
/// The pixels of an image of GL_DEPTH_STENCIL.
DepthsAndStencils host_depths_and_stencils(const Context& context, GLsizei width, GLsizei height,
                                           const HostImage& image);

/// Pixels of 8 bits a channel, R in the lowest byte, after transfer and quantized to `bits` bits.
std::vector<Rgba> transferred_rgba(const Context& context, std::span<const std::uint32_t> pixels,
                                   int bits);
/// The same as bytes of a format other than luminance. `out` may be the pixels' memory if the format
/// has four components.
void pack_bytes(const Context& context, std::span<const std::uint32_t> pixels, GLenum format,
                std::byte* out);

/// Rows of pixels in a format and type, from colours after transfer.
std::vector<std::byte> packed_colors(const std::vector<vec4>& colors, GLenum format, GLenum type);
/// Pixels of GL_DEPTH_STENCIL, from depths and stencil values after transfer.
std::vector<std::byte> packed_depths_and_stencils(const DepthsAndStencils& values);
/// The same for depths or indices. `width`: pixels of a row.
std::vector<std::byte> packed_values(const std::vector<double>& values, GLsizei width,
                                     GLenum format, GLenum type);

}  // namespace gw::gl
