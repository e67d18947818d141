#include "gl/pixels/transfer.h"

#include "gl/api/convert.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/packed.h"
#include "gl/pixels/plain_pixels.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/resolve.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gw::gl {

namespace {

float clamp01f(float v) { return v >= 0 ? std::min(v, 1.0f) : 0.0f; }

/// A map's entry for a colour component 0 .. 1. [GL11] 3.6.5
float looked_up(const std::vector<float>& map, float v) {
    const float last = float(map.size() - 1);
    return map[std::size_t(std::floor(clamp01f(v) * last + 0.5f))];
}
/// A map's entry for an index; its size is a power of two.
float looked_up(const std::vector<float>& map, GLuint index) {
    return map[index & (map.size() - 1)];
}

/// Shift and offset.
GLuint transferred_index(const Context& context, double index) {
    const PixelState& s = context.state.pixel;
    const auto whole = static_cast<std::int64_t>(clamped(finite(index), -0x1p31, 0x1p32));
    const int shift = std::clamp(s.index_shift, -31, 31);
    const std::int64_t shifted = shift >= 0 ? whole << shift : whole >> -shift;
    return GLuint(shifted + s.index_offset);
}

vec4 color_of_index(const Context& context, GLuint index) {
    return {clamp01f(looked_up(context.pixel_maps[GL_PIXEL_MAP_I_TO_R], index)),
            clamp01f(looked_up(context.pixel_maps[GL_PIXEL_MAP_I_TO_G], index)),
            clamp01f(looked_up(context.pixel_maps[GL_PIXEL_MAP_I_TO_B], index)),
            clamp01f(looked_up(context.pixel_maps[GL_PIXEL_MAP_I_TO_A], index))};
}

/// [GL11] 3.6.4, "Conversion to RGB": the components of a format in their places.
vec4 color_of(GLenum format, const std::array<double, 4>& v) {
    const auto f = [&](std::size_t i) { return float(v[i]); };
    switch (format) {
        case GL_RED: return {f(0), 0, 0, 1};
        case GL_GREEN: return {0, f(0), 0, 1};
        case GL_BLUE: return {0, 0, f(0), 1};
        case GL_ALPHA: return {0, 0, 0, f(0)};
        case GL_LUMINANCE: return {f(0), f(0), f(0), 1};
        case GL_LUMINANCE_ALPHA: return {f(0), f(0), f(0), f(1)};
        case GL_RGB: return {f(0), f(1), f(2), 1};
        case GL_BGR: return {f(2), f(1), f(0), 1};
        case GL_BGRA: return {f(2), f(1), f(0), f(3)};
        case GL_ABGR_EXT: return {f(3), f(2), f(1), f(0)};
    }
    return {f(0), f(1), f(2), f(3)};
}

/// [GL11] 4.3.2: the components of a format from a colour, clamped.
std::array<double, 4> components_of(GLenum format, const vec4& c) {
    const double luminance = std::min(double(c.x) + double(c.y) + double(c.z), 1.0);
    switch (format) {
        case GL_RED: return {c.x};
        case GL_GREEN: return {c.y};
        case GL_BLUE: return {c.z};
        case GL_ALPHA: return {c.w};
        case GL_LUMINANCE: return {luminance};
        case GL_LUMINANCE_ALPHA: return {luminance, c.w};
        case GL_BGR: return {c.z, c.y, c.x};
        case GL_BGRA: return {c.z, c.y, c.x, c.w};
        case GL_ABGR_EXT: return {c.w, c.z, c.y, c.x};
    }
    return {c.x, c.y, c.z, c.w};
}

/// The components of several colours, side by side.
void fill_components(GLenum format, std::span<const vec4> colors, std::span<double> out) {
    const auto count = std::size_t(component_count(format));
    const std::array<double, 4> channels = components_of(format, {0, 1, 2, 3});
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (std::size_t k = 0; k < count; ++k)
            out[i * count + k] = double(colors[i][int(channels[k])]);
    if (format != GL_LUMINANCE && format != GL_LUMINANCE_ALPHA) return;
    for (std::size_t i = 0; i < colors.size(); ++i)
        out[i * count] = components_of(format, colors[i])[0];
}

/// Calls `take(values)` for each pixel.
template <class Take>
void for_each_pixel(GLsizei width, GLsizei height, GLenum format, GLenum type,
                    const HostImage& image, Take take) {
    const std::byte* row = image.bytes.data();
    const auto count = std::size_t(component_count(format));
    const std::size_t bytes = component_bytes(type);
    const PackedType* const packed = packed_type(type);
    for (GLsizei y = 0; y < height; ++y, row += row_bytes(width, format, type)) {
        const std::byte* at = row;
        for (std::size_t x = 0; x < std::size_t(width); ++x) {
            std::array<double, 4> v{};
            if (type == GL_BITMAP)
                v[0] = std::to_integer<int>(row[x / 8]) >> (7 - x % 8) & 1;
            else if (packed != nullptr)
                v = load_packed(*packed, at), at += bytes;
            else
                for (std::size_t i = 0; i < count; ++i, at += bytes)
                    v[i] = load_component(type, at, is_index_format(format));
            take(v);
        }
    }
}

/// Calls `take(colour)` for each pixel, after transfer.
void for_each_host_color(const Context& context, GLsizei width, GLsizei height, GLenum format,
                         GLenum type, const HostImage& image, const auto& take) {
    for_each_pixel(width, height, format, type, image, [&](const std::array<double, 4>& v) {
        take(format == GL_COLOR_INDEX ? color_of_index(context, transferred_index(context, v[0]))
                                      : transferred_color(context, color_of(format, v)));
    });
}

/// A depth 0 .. 1 in 24 bits.
std::uint32_t nearest_depth(double depth) {
    return std::uint32_t(std::clamp(depth, 0.0, 1.0) * 16777215.0 + 0.5);
}

/// What becomes of each byte of each channel: transfer treats channels one by one.
template <class T>
using ByteTables = std::array<std::array<T, 256>, 4>;
template <class T, class Value>
ByteTables<T> byte_tables(const Context& context, Value value) {
    ByteTables<T> tables;
    for (std::size_t byte = 0; byte < 256; ++byte) {
        const vec4 color = transferred_color(context, vec4(float(unit(GLubyte(byte)))));
        for (std::size_t i = 0; i < 4; ++i) tables[i][byte] = value(color[int(i)]);
    }
    return tables;
}
template <class T>
ByteTables<T> quantized_bytes(const Context& context, int bits) {
    return byte_tables<T>(context, [&](float v) { return T(quantize(double(v), bits)); });
}

/// Smaller images are transferred without tables.
constexpr std::size_t fewest_pixels = 512;

/// The component that each channel comes from; 4: it is 0, 5: it is 1.
std::array<std::size_t, 4> component_of_channel(GLenum format) {
    const vec4 found = color_of(format, {2, 3, 4, 5});
    std::array<std::size_t, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) {
        const float v = found[int(i)];
        out[i] = v >= 2 ? std::size_t(v) - 2 : v == 0 ? 4 : 5;
    }
    return out;
}

/// What becomes of a channel, by the values of the component that it comes from.
struct PackedChannel {
    PackedComponent from;
    std::vector<std::uint16_t> table;
};

void store_packed_rgba(const Context& context, const PackedType& packed, GLenum format,
                       std::span<const std::byte> bytes, int bits, std::span<Rgba> out) {
    const std::array<PackedComponent, 4> components = packed_components(packed);
    const std::array<std::size_t, 4> from = component_of_channel(format);
    std::array<PackedChannel, 4> channels;
    for (std::size_t k = 0; k < 4; ++k) {
        PackedChannel& channel = channels[k];
        if (from[k] < 4) channel.from = components[from[k]];
        for (std::uint32_t v = 0; v <= channel.from.largest; ++v) {
            const double value = from[k] < 4    ? double(v) / double(channel.from.largest)
                                 : from[k] == 5 ? 1
                                                : 0;
            const vec4 color = transferred_color(context, vec4(float(value)));
            channel.table.push_back(std::uint16_t(quantize(double(color[int(k)]), bits)));
        }
    }
    const std::byte* at = bytes.data();
    const auto store = [&](auto number) {
        for (Rgba& pixel : out) {
            std::memcpy(&number, at, sizeof number);
            const auto channel = [&](std::size_t k) {
                const PackedComponent& c = channels[k].from;
                return channels[k].table[number >> c.shift & c.largest];
            };
            pixel = {channel(0), channel(1), channel(2), channel(3)};
            at += sizeof number;
        }
    };
    if (packed.bytes == 1)
        store(std::uint8_t{});
    else if (packed.bytes == 2)
        store(std::uint16_t{});
    else
        store(std::uint32_t{});
}

}  // namespace

bool leaves_stencils(const PixelState& s) {
    return s.index_shift == 0 && s.index_offset == 0 && !s.map_stencil;
}

bool leaves_colors(const PixelState& s) {
    return s.scale == vec4(1) && s.bias == vec4(0) && !s.map_color;
}

vec4 transferred_color(const Context& context, vec4 color) {
    const PixelState& s = context.state.pixel;
    for (int i = 0; i < 4; ++i) color[i] = clamp01f(color[i] * s.scale[i] + s.bias[i]);
    if (!s.map_color) return color;
    for (int i = 0; i < 4; ++i)
        color[i] =
            clamp01f(looked_up(context.pixel_maps[GL_PIXEL_MAP_R_TO_R + GLenum(i)], color[i]));
    return color;
}

double transferred_depth(const Context& context, double depth) {
    const PixelState& s = context.state.pixel;
    return clamped(depth * double(s.depth_scale) + double(s.depth_bias), 0.0, 1.0);
}

GLuint transferred_stencil(const Context& context, double index) {
    const GLuint out = transferred_index(context, index);
    if (!context.state.pixel.map_stencil) return out;
    return GLuint(looked_up(context.pixel_maps[GL_PIXEL_MAP_S_TO_S], out));
}

std::vector<Rgba> host_rgba(const Context& context, GLsizei width, GLsizei height, GLenum format,
                            GLenum type, const HostImage& image, int bits) {
    std::vector<Rgba> out(std::size_t(width) * std::size_t(height));
    store_host_rgba(context, width, height, format, type, image, bits, out);
    return out;
}

void store_host_rgba(const Context& context, GLsizei width, GLsizei height, GLenum given_format,
                     GLenum given_type, const HostImage& image, int bits, std::span<Rgba> out) {
    const auto [format, type] = as_bytes(given_format, given_type);
    if (leaves_colors(context.state.pixel) && plain_colors(format, type, image.bytes, bits, out))
        return;
    if (const PackedType* const packed = packed_type(type); packed && out.size() >= fewest_pixels)
        return store_packed_rgba(context, *packed, format, image.bytes, bits, out);
    Rgba* to = out.data();
    if (type != GL_UNSIGNED_BYTE || format == GL_COLOR_INDEX || out.size() < fewest_pixels)
        return for_each_host_color(context, width, height, format, type, image,
                                   [&](const vec4& color) { *to++ = quantize_color(color, bits); });
    const auto tables = quantized_bytes<std::uint16_t>(context, bits);
    const auto from = component_of_channel(format);
    const auto count = std::size_t(component_count(format));
    const std::byte* at = image.bytes.data();
    std::array<std::byte, 6> v{};
    v[5] = std::byte{255};
    for (Rgba& pixel : out) {
        std::copy_n(at, count, v.data());
        const auto channel = [&](std::size_t k) {
            return tables[k][std::to_integer<std::size_t>(v[from[k]])];
        };
        pixel = {channel(0), channel(1), channel(2), channel(3)};
        at += count;
    }
}

std::vector<Rgba> transferred_rgba(const Context& context, std::span<const std::uint32_t> pixels,
                                   int bits) {
    const auto tables = quantized_bytes<std::uint16_t>(context, bits);
    std::vector<Rgba> out;
    out.reserve(pixels.size());
    for (const std::uint32_t p : pixels)
        out.push_back({tables[0][p & 255], tables[1][p >> 8 & 255], tables[2][p >> 16 & 255],
                       tables[3][p >> 24]});
    return out;
}

std::vector<double> host_depths(const Context& context, GLsizei width, GLsizei height, GLenum type,
                                const HostImage& image) {
    std::vector<double> out(std::size_t(width) * std::size_t(height));
    load_components(type, image.bytes.data(), out, false);
    for (double& depth : out) depth = transferred_depth(context, depth);
    return out;
}

std::vector<GLuint> host_stencils(const Context& context, GLsizei width, GLsizei height,
                                  GLenum type, const HostImage& image) {
    std::vector<GLuint> out;
    out.reserve(std::size_t(width) * std::size_t(height));
    if (type == GL_UNSIGNED_BYTE && leaves_stencils(context.state.pixel)) {
        for (const std::byte stencil : image.bytes.first(out.capacity()))
            out.push_back(std::to_integer<GLuint>(stencil));
        return out;
    }
    for_each_pixel(width, height, GL_STENCIL_INDEX, type, image,
                   [&](const auto& v) { out.push_back(transferred_stencil(context, v[0])); });
    return out;
}

DepthsAndStencils host_depths_and_stencils(const Context& context, GLsizei width, GLsizei height,
                                           const HostImage& image) {
    DepthsAndStencils out;
    for_each_pixel(width, height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, image,
                   [&](const auto& v) {
                       out.depths.push_back(transferred_depth(context, v[0]));
                       out.stencils.push_back(transferred_stencil(context, std::round(v[1] * 255)));
                   });
    return out;
}

std::vector<std::byte> packed_depths_and_stencils(const DepthsAndStencils& values) {
    const PackedType& packed = *packed_type(GL_UNSIGNED_INT_24_8);
    std::vector<std::byte> out(values.depths.size() * packed.bytes);
    for (std::size_t i = 0; i < values.depths.size(); ++i)
        store_packed_number(packed, &out[i * packed.bytes],
                            nearest_depth(values.depths[i]) << 8 | (values.stencils[i] & 255));
    return out;
}

std::vector<std::byte> packed_colors(const std::vector<vec4>& colors, GLenum given_format,
                                     GLenum given_type) {
    const auto [format, type] = as_bytes(given_format, given_type);
    const PackedType* const packed = packed_type(type);
    const auto count = std::size_t(packed != nullptr ? 1 : component_count(format));
    const std::size_t bytes = component_bytes(type);
    std::vector<std::byte> out(colors.size() * count * bytes);
    std::byte* at = out.data();
    if (packed != nullptr) {
        for (const vec4& color : colors)
            store_packed(*packed, at, components_of(format, color)), at += bytes;
        return out;
    }
    std::array<double, 256> values;
    for (std::span<const vec4> rest(colors); !rest.empty();) {
        const auto part = rest.first(std::min(rest.size(), values.size() / 4));
        fill_components(format, part, values);
        store_components(type, at, std::span(values).first(part.size() * count), false);
        at += part.size() * count * bytes;
        rest = rest.subspan(part.size());
    }
    return out;
}

void pack_bytes(const Context& context, std::span<const std::uint32_t> pixels, GLenum format,
                std::byte* out) {
    if (leaves_colors(context.state.pixel) && pack_words(pixels, format, out)) return;
    const auto count = std::size_t(component_count(format));
    const std::array<double, 4> channels = components_of(format, {0, 1, 2, 3});
    const auto tables = byte_tables<std::byte>(context, [](float v) {
        std::byte byte;
        store_component(GL_UNSIGNED_BYTE, &byte, double(v), false);
        return byte;
    });
    for (const std::uint32_t p : pixels)
        for (std::size_t i = 0; i < count; ++i) {
            const auto channel = std::size_t(channels[i]);
            *out++ = tables[channel][p >> 8 * channel & 255];
        }
}

std::vector<std::byte> packed_values(const std::vector<double>& values, GLsizei width,
                                     GLenum format, GLenum type) {
    const std::size_t n = std::size_t(width), rows = values.size() / n;
    const std::size_t row = row_bytes(width, format, type);
    std::vector<std::byte> out(rows * row);
    for (std::size_t y = 0; y < rows; ++y) {
        const std::span from(&values[y * n], n);
        std::byte* const to = &out[y * row];
        if (type != GL_BITMAP) {
            store_components(type, to, from, is_index_format(format));
            continue;
        }
        for (std::size_t x = 0; x < n; ++x)
            if (static_cast<std::int64_t>(from[x]) & 1) to[x / 8] |= std::byte(0x80u >> x % 8);
    }
    return out;
}

}  // namespace gw::gl
