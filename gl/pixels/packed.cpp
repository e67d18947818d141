#include "gl/pixels/packed.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace gw::gl {

namespace {

constexpr PackedType packed_types[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, {3, 3, 2, 0}, false},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, {3, 3, 2, 0}, true},
    {GL_UNSIGNED_SHORT_5_6_5, 2, {5, 6, 5, 0}, false},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, {5, 6, 5, 0}, true},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, {4, 4, 4, 4}, false},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, {4, 4, 4, 4}, true},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, {5, 5, 5, 1}, false},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, {5, 5, 5, 1}, true},
    {GL_UNSIGNED_INT_8_8_8_8, 4, {8, 8, 8, 8}, false},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, {8, 8, 8, 8}, true},
    {GL_UNSIGNED_INT_10_10_10_2, 4, {10, 10, 10, 2}, false},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, {10, 10, 10, 2}, true},
    {GL_UNSIGNED_INT_24_8, 4, {24, 8, 0, 0}, false},
};

std::uint32_t load_number(std::size_t bytes, const std::byte* at) {
    std::uint8_t byte = 0;
    std::uint16_t word = 0;
    std::uint32_t number = 0;
    if (bytes == 1) return std::memcpy(&byte, at, 1), byte;
    if (bytes == 2) return std::memcpy(&word, at, 2), word;
    return std::memcpy(&number, at, 4), number;
}

void store_number(std::size_t bytes, std::byte* at, std::uint32_t number) {
    const auto byte = std::uint8_t(number);
    const auto word = std::uint16_t(number);
    if (bytes == 1)
        std::memcpy(at, &byte, 1);
    else if (bytes == 2)
        std::memcpy(at, &word, 2);
    else
        std::memcpy(at, &number, 4);
}

/// Calls `take(i, shift, largest)` for each component.
template <class Take>
void for_each_component(const PackedType& packed, Take take) {
    unsigned low = 0, high = unsigned(8 * packed.bytes);
    for (std::size_t i = 0; i < packed.bits.size() && packed.bits[i] != 0; ++i) {
        high -= packed.bits[i];
        take(i, packed.reversed ? low : high, (1u << packed.bits[i]) - 1);
        low += packed.bits[i];
    }
}

}  // namespace

const PackedType* packed_type(GLenum type) {
    for (const PackedType& packed : packed_types)
        if (packed.type == type) return &packed;
    return nullptr;
}

bool is_packed_format(const PackedType& packed, GLenum format) {
    if (packed.bits[2] == 0) return format == GL_DEPTH_STENCIL;
    if (packed.bits[3] == 0) return format == GL_RGB;
    // [EXT_abgr] ABGR has alpha where others have red: only of as many bits, as on Mesa.
    if (format == GL_ABGR_EXT) return packed.bits[0] == packed.bits[3];
    return format == GL_RGBA || format == GL_BGRA;
}

PixelType as_bytes(GLenum format, GLenum type) {
    if constexpr (std::endian::native == std::endian::little) {
        if (type == GL_UNSIGNED_INT_8_8_8_8_REV) return {format, GL_UNSIGNED_BYTE};
        if (type == GL_UNSIGNED_INT_8_8_8_8 && format == GL_RGBA)
            return {GL_ABGR_EXT, GL_UNSIGNED_BYTE};
        if (type == GL_UNSIGNED_INT_8_8_8_8 && format == GL_ABGR_EXT)
            return {GL_RGBA, GL_UNSIGNED_BYTE};
    }
    return {format, type};
}

void store_packed_number(const PackedType& packed, std::byte* at, std::uint32_t number) {
    store_number(packed.bytes, at, number);
}

std::array<PackedComponent, 4> packed_components(const PackedType& packed) {
    std::array<PackedComponent, 4> out;
    for_each_component(packed, [&](std::size_t i, unsigned shift, unsigned largest) {
        out[i] = {shift, largest};
    });
    return out;
}

std::array<double, 4> load_packed(const PackedType& packed, const std::byte* at) {
    const std::uint32_t number = load_number(packed.bytes, at);
    std::array<double, 4> values{};
    for_each_component(packed, [&](std::size_t i, unsigned shift, unsigned largest) {
        values[i] = double(number >> shift & largest) / double(largest);
    });
    return values;
}

void store_packed(const PackedType& packed, std::byte* at, const std::array<double, 4>& values) {
    std::uint32_t number = 0;
    for_each_component(packed, [&](std::size_t i, unsigned shift, unsigned largest) {
        const double value = std::clamp(values[i], 0.0, 1.0) * double(largest);
        number |= std::uint32_t(std::floor(value + 0.5)) << shift;  // to nearest
    });
    store_number(packed.bytes, at, number);
}

}  // namespace gw::gl
