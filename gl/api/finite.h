// Clamps a program's numbers to those that the machine takes; NaN becomes 0.
#pragma once

#include "gw/base/finite.h"

#include <glm/vec4.hpp>

#include <limits>

namespace gw::gl {

/// NaN is `low`.
template <class T>
constexpr T clamped(T v, T low, T high) {
    if (!(v >= low)) return low;
    return v <= high ? v : high;
}

/// NaN becomes 0, a number beyond float the largest float.
template <class T>
constexpr T finite(T v) {
    constexpr T largest = T(std::numeric_limits<float>::max());
    return v != v ? T(0) : clamped(v, -largest, largest);
}

/// Whether no component is infinite or NaN.
inline bool all_finite(const glm::vec4& v) { return gw::all_finite(&v.x, 4); }

/// finite() of each component.
template <glm::length_t n, class T>
glm::vec<n, T> finite(glm::vec<n, T> v) {
    for (glm::length_t i = 0; i < n; ++i) v[i] = finite(v[i]);
    return v;
}

inline glm::vec4 finite(const glm::vec4& v) {
    if (all_finite(v)) [[likely]]
        return v;
    return finite<4, float>(v);
}

}  // namespace gw::gl
