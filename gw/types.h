// Vectors and matrices of the machine: GLM's, by the names used everywhere else.
// Does not use GLM's transcendental functions (rotate, perspective, pow): they call libm, and libm differs.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
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

/// One pixel's R, G, B, A as the frame buffer holds them: integers in 0 .. 2^color_bits - 1.
using Rgba = std::array<std::uint16_t, 4>;

/// A rectangle of pixels; x, y is its lower left pixel (window origin bottom left, as in GL).
struct Rect {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Rect&) const = default;
};

}  // namespace gw
