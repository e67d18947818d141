#include "gl/pixels/byte_formats.h"

#include <cstring>

namespace gw::gl {

namespace {

/// Pixels of Count components. From: the components of R, G, B, A; Count: 255.
template <std::size_t Count, std::size_t... From>
bool scale(std::span<const std::byte> bytes, std::uint16_t factor, std::vector<Rgba>& out) {
    const std::byte* from = bytes.data();
    for (Rgba& pixel : out) {
        const auto channel = [&](std::size_t i) {
            const unsigned byte = i < Count ? std::to_integer<unsigned>(from[i]) : 255;
            return std::uint16_t(byte * factor);
        };
        pixel = {channel(From)...};
        from += Count;
    }
    return true;
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

bool scale_bytes(GLenum format, std::span<const std::byte> bytes, std::uint16_t factor,
                 std::vector<Rgba>& out) {
    switch (format) {
        case GL_RGBA: return scale<4, 0, 1, 2, 3>(bytes, factor, out);
        case GL_BGRA: return scale<4, 2, 1, 0, 3>(bytes, factor, out);
        case GL_RGB: return scale<3, 0, 1, 2, 3>(bytes, factor, out);
        case GL_BGR: return scale<3, 2, 1, 0, 3>(bytes, factor, out);
        case GL_LUMINANCE: return scale<1, 0, 0, 0, 1>(bytes, factor, out);
        case GL_LUMINANCE_ALPHA: return scale<2, 0, 0, 0, 1>(bytes, factor, out);
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
