// The machine's vectors, matrices, colours and rectangles. Vectors and matrices are GLM's.
// Does not use GLM's transcendental functions (rotate, perspective, pow): they call libm, whose
// results differ between platforms.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gw {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// Products in one fixed order of operations: (x + y) + z, (x + y) + (z + w). GLM has none.
constexpr double dot3(const dvec3& a, const dvec3& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
constexpr double dot4(const dvec4& a, const dvec4& b) {
    return (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w);
}
inline double length(const dvec3& v) { return std::sqrt(dot3(v, v)); }
constexpr dvec3 cross3(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr dvec3 transform3(const dmat3& m, const dvec3& v) {
    return {(m[0].x * v.x + m[1].x * v.y) + m[2].x * v.z,
            (m[0].y * v.x + m[1].y * v.y) + m[2].y * v.z,
            (m[0].z * v.x + m[1].z * v.y) + m[2].z * v.z};
}

/// One pixel's R, G, B, A as in the frame buffer: integers in 0 .. 2^color_bits - 1.
using Rgba = std::array<std::uint16_t, 4>;

/// A colour of at most 8 bits a channel in one word, R lowest.
constexpr std::uint32_t packed(const Rgba& c) {
    return std::uint32_t(c[0]) | std::uint32_t(c[1]) << 8 | std::uint32_t(c[2]) << 16 |
           std::uint32_t(c[3]) << 24;
}
constexpr Rgba unpacked(std::uint32_t c) {
    return {std::uint16_t(c & 0xFF), std::uint16_t(c >> 8 & 0xFF), std::uint16_t(c >> 16 & 0xFF),
            std::uint16_t(c >> 24)};
}

/// The index of pixel x, y in rows of `width` pixels.
constexpr std::size_t pixel_index(int x, int y, int width) {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
}

/// A rectangle of pixels; x, y is its lower left pixel (window origin bottom left, as in GL).
struct Rect {
    int x = 0, y = 0, width = 0, height = 0;

    /// The area of a rectangle whose sides are not negative.
    constexpr std::size_t area() const { return std::size_t(width) * std::size_t(height); }
    /// The index of the window's pixel i, j in the rectangle's rows.
    constexpr std::size_t index(int i, int j) const { return pixel_index(i - x, j - y, width); }
    bool operator==(const Rect&) const = default;
};

}  // namespace gw
