// Barycentric weights of a point in a triangle, and interpolation by them.
#pragma once

#include "gw/base/types.h"

#include <algorithm>
#include <array>

namespace gw::scene {

/// Of three corners; they sum to 1.
using Weights = std::array<double, 3>;

/// Weights of the point at which the line origin + t direction meets the triangle's plane; the
/// first corner's if they are parallel, or the triangle has no area.
inline Weights weights_at(const std::array<dvec3, 3>& corner, const dvec3& origin,
                          const dvec3& direction) {
    const dvec3 u = corner[1] - corner[0], v = corner[2] - corner[0], n = cross3(u, v);
    const double slope = dot3(n, direction), size = dot3(n, n);
    if (slope == 0 || size == 0) return {1, 0, 0};
    const dvec3 d = origin + (dot3(n, corner[0] - origin) / slope) * direction - corner[0];
    const double b = dot3(cross3(d, v), n) / size, c = dot3(cross3(u, d), n) / size;
    return {1 - b - c, b, c};
}

/// Approximately the nearest point of the triangle: negative weights become 0.
inline Weights inside(Weights w) {
    double sum = 0;
    for (double& value : w) sum += value = std::max(value, 0.0);
    for (double& value : w) value /= sum;
    return w;
}

template <class Vector>
Vector mix(const Weights& w, const std::array<Vector, 3>& v) {
    return w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
}

}  // namespace gw::scene
