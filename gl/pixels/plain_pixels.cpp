#include "gl/pixels/plain_pixels.h"

#include "gl/api/convert.h"
#include "gw/base/arithmetic.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

namespace gw::gl {

namespace {

/// A component of value 1.
template <class T>
constexpr T component_of_one = std::is_integral_v<T> ? std::numeric_limits<T>::max() : T(1);

/// Channels from pixels of Count components. From: the components of R, G, B, A; Count: 1, Count + 1:
/// 0.
template <class T, std::size_t Count, std::size_t... From>
bool convert(std::span<const std::byte> bytes, const auto& channel_of, std::span<Rgba> out) {
    const std::uint16_t one = channel_of(component_of_one<T>);
    for (std::size_t p = 0; p < out.size(); ++p) {
        std::array<std::uint16_t, Count + 2> values;
        for (std::size_t i = 0; i < Count; ++i) {
            T component;
            std::memcpy(&component, bytes.data() + (p * Count + i) * sizeof(T), sizeof(T));
            values[i] = channel_of(component);
        }
        values[Count] = one;
        values[Count + 1] = 0;
        out[p] = {values[From]...};
    }
    return true;
}

/// R, G, B, A: components one by one.
template <class T>
bool convert_rgba(std::span<const std::byte> bytes, const auto& channel_of, std::span<Rgba> out) {
    std::uint16_t* const to = out.empty() ? nullptr : out.front().data();
    for (std::size_t i = 0; i < 4 * out.size(); ++i) {
        T component;
        std::memcpy(&component, bytes.data() + i * sizeof component, sizeof component);
        to[i] = channel_of(component);
    }
    return true;
}

template <class T>
bool convert(GLenum format, std::span<const std::byte> bytes, const auto& channel_of,
             std::span<Rgba> out) {
    switch (format) {
        case GL_RGBA: return convert_rgba<T>(bytes, channel_of, out);
        case GL_BGRA: return convert<T, 4, 2, 1, 0, 3>(bytes, channel_of, out);
        case GL_ABGR_EXT: return convert<T, 4, 3, 2, 1, 0>(bytes, channel_of, out);
        case GL_RGB: return convert<T, 3, 0, 1, 2, 3>(bytes, channel_of, out);
        case GL_BGR: return convert<T, 3, 2, 1, 0, 3>(bytes, channel_of, out);
        case GL_LUMINANCE: return convert<T, 1, 0, 0, 0, 1>(bytes, channel_of, out);
        case GL_LUMINANCE_ALPHA: return convert<T, 2, 0, 0, 0, 1>(bytes, channel_of, out);
        case GL_ALPHA: return convert<T, 1, 2, 2, 2, 0>(bytes, channel_of, out);
    }
    return false;
}

/// quantize() of a component's value, in order. No branch: a number plus 1.5 2^52 has its nearest
/// integer in the lowest bits.
template <class T>
bool quantized(GLenum format, std::span<const std::byte> bytes, int bits, std::span<Rgba> out) {
    const double max = double(max_of_bits(bits));
    const auto channel_of = [max](T component) {
        float value;
        if constexpr (std::is_integral_v<T>)
            value = float(unit(component));
        else
            value = component;
        const double rounded = double(value >= 0 ? std::min(value, 1.0f) : 0.0f) * max + 0x1.8p52;
        return std::uint16_t(std::bit_cast<std::uint64_t>(rounded));
    };
    return convert<T>(format, bytes, channel_of, out);
}

/// Integers that are multiplied: unsigned ones of as many bits as colours, or half as many.
template <class T>
bool multiplied(GLenum format, std::span<const std::byte> bytes, int bits, std::span<Rgba> out) {
    const auto factor = std::uint16_t(max_of_bits(bits) / std::numeric_limits<T>::max());
    return convert<T>(
        format, bytes, [factor](T v) { return std::uint16_t(v * factor); }, out);
}

/// Channels: of the components.
template <std::size_t... Channels>
bool pack(std::span<const std::uint32_t> words, std::byte* out) {
    for (const std::uint32_t word : words) ((*out++ = std::byte(word >> 8 * Channels & 255)), ...);
    return true;
}

bool swap_red_and_blue(std::span<const std::uint32_t> words, std::byte* out) {
    for (const std::uint32_t word : words) {
        const std::uint32_t swapped =
            (word & 0xFF00FF00) | (word & 0xFF) << 16 | (word >> 16 & 0xFF);
        std::memcpy(out, &swapped, sizeof swapped);
        out += sizeof swapped;
    }
    return true;
}

}  // namespace

bool plain_colors(GLenum format, GLenum type, std::span<const std::byte> bytes, int bits,
                  std::span<Rgba> out) {
    switch (type) {
        case GL_BYTE: return quantized<GLbyte>(format, bytes, bits, out);
        case GL_UNSIGNED_BYTE:
            if (bits % 8 == 0) return multiplied<GLubyte>(format, bytes, bits, out);
            return quantized<GLubyte>(format, bytes, bits, out);
        case GL_SHORT: return quantized<GLshort>(format, bytes, bits, out);
        case GL_UNSIGNED_SHORT:
            if (bits == 16) return multiplied<GLushort>(format, bytes, bits, out);
            return quantized<GLushort>(format, bytes, bits, out);
        case GL_INT: return quantized<GLint>(format, bytes, bits, out);
        case GL_UNSIGNED_INT: return quantized<GLuint>(format, bytes, bits, out);
        case GL_FLOAT: return quantized<GLfloat>(format, bytes, bits, out);
    }
    return false;
}

bool pack_words(std::span<const std::uint32_t> words, GLenum format, std::byte* out) {
    switch (format) {
        case GL_RGBA: std::memmove(out, words.data(), words.size_bytes()); return true;
        case GL_BGRA: return swap_red_and_blue(words, out);
        case GL_RGB: return pack<0, 1, 2>(words, out);
        case GL_BGR: return pack<2, 1, 0>(words, out);
    }
    return false;
}

}  // namespace gw::gl
