// A ray and a sphere, by the discriminant [L10]. Does not know scenes.
#pragma once

#include "raytrace/casting/ray.h"

#include <cmath>
#include <optional>

namespace gw::raytrace {

struct Sphere {
    dvec3 center{0};  ///< S
    double radius = 1;
};

/// Where the ray enters the sphere, or leaves it if it starts inside; t > 0, in lengths of the
/// direction.
/// With |E| = 1: t^2 + 2 b t + c = 0, b = E.(P_E - S), c = |P_E - S|^2 - r^2; real where b^2 - c >=
/// 0.
inline std::optional<double> intersect(const Ray& ray, const Sphere& sphere) {
    const double length = std::sqrt(dot3(ray.direction, ray.direction));
    const dvec3 from_center = ray.origin - sphere.center;
    const double b = dot3(ray.direction, from_center) / length;
    const double c = dot3(from_center, from_center) - sphere.radius * sphere.radius;
    const double discriminant = b * b - c;
    if (!(discriminant >= 0)) return std::nullopt;
    const double root = std::sqrt(discriminant);
    const double t = -b - root > 0 ? -b - root : -b + root;
    if (!(t > 0)) return std::nullopt;
    return t / length;
}

/// N = (P - S) / r
inline dvec3 normal_at(const Sphere& sphere, const dvec3& p) {
    return (p - sphere.center) / sphere.radius;
}

}  // namespace gw::raytrace
