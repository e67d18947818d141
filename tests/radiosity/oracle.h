// Form factors found in other ways than by hemicubes: in closed form, and by sums of closed forms.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cmath>
#include <vector>

namespace gw::radiosity {

/// A parallelogram facing cross(a, b).
struct Quad {
    dvec3 corner, a, b;
    dvec3 at(double s, double t) const { return corner + s * a + t * b; }
    dvec3 cross() const { return cross3(a, b); }
    std::vector<dvec3> border() const { return {corner, corner + a, corner + a + b, corner + b}; }
};

/// Howell C-11: equal rectangles a x b, opposite each other at distance c.
inline double parallel_rectangles(double a, double b, double c) {
    const double x = a / c, y = b / c, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    const double log = std::log((1 + x * x) * (1 + y * y) / (1 + x * x + y * y)) / 2;
    return 2 / (M_PI * x * y) *
           (log + x * q * std::atan(x / q) + y * p * std::atan(y / p) - x * std::atan(x) -
            y * std::atan(y));
}

/// Howell C-14: from a rectangle w deep to one h high that stands on their common edge, l long.
inline double perpendicular_rectangles(double w, double h, double l) {
    const double W = w / l, H = h / l, W2 = W * W, H2 = H * H, s = H2 + W2, r = std::sqrt(s);
    const double log = std::log((1 + W2) * (1 + H2) / (1 + s)) +
                       W2 * std::log(W2 * (1 + s) / ((1 + W2) * s)) +
                       H2 * std::log(H2 * (1 + s) / ((1 + H2) * s));
    return (W * std::atan(1 / W) + H * std::atan(1 / H) - r * std::atan(1 / r) + log / 4) /
           (M_PI * W);
}

/// Howell C-41: from a disc of radius r1 to a coaxial one of radius r2 at distance h.
inline double coaxial_discs(double r1, double r2, double h) {
    const double R1 = r1 / h, R2 = r2 / h, x = 1 + (1 + R2 * R2) / (R1 * R1);
    return (x - std::sqrt(x * x - 4 * (R2 / R1) * (R2 / R1))) / 2;
}

/// Lambert 1760: from a point with this normal to a polygon that is wholly over its horizon and
/// faces it.
inline double point_to_polygon(const dvec3& p, const dvec3& normal,
                               const std::vector<dvec3>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec3 a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p, n = cross3(a, b);
        const double size = length(n);
        if (size > 0) sum += std::atan2(size, dot3(a, b)) * dot3(normal, n) / size;
    }
    return std::abs(sum) / (2 * M_PI);
}

/// The mean of point_to_polygon over n x n points.
inline double quad_to_quad(const Quad& from, const Quad& to, int n = 300) {
    const dvec3 normal = from.cross() / length(from.cross());
    double sum = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            sum += point_to_polygon(from.at((i + 0.5) / n, (j + 0.5) / n), normal, to.border());
    return sum / (n * n);
}

/// With one parallelogram in the way: the mean over pairs of n x n points each.
inline double quad_to_quad_behind(const Quad& from, const Quad& to, const Quad& occluder,
                                  int n = 48) {
    const dvec3 m = from.cross() / length(from.cross()), k = to.cross(), o = occluder.cross();
    const auto hidden = [&](const dvec3& p, const dvec3& d) {
        const double t = dot3(o, occluder.corner - p) / dot3(o, d);
        if (!(t > 0 && t < 1)) return false;
        const dvec3 q = p + t * d - occluder.corner;
        const double u = dot3(q, occluder.a) / dot3(occluder.a, occluder.a),
                     v = dot3(q, occluder.b) / dot3(occluder.b, occluder.b);
        return u > 0 && u < 1 && v > 0 && v < 1;
    };
    double sum = 0;
    for (int e = 0; e < n * n; ++e)
        for (int r = 0; r < n * n; ++r) {
            // NOLINT: whole numbers
            const dvec3 p = from.at((e % n + 0.5) / n, (e / n + 0.5) / n);
            const dvec3 d = to.at((r % n + 0.5) / n, (r / n + 0.5) / n) - p;  // NOLINT
            const double d2 = dot3(d, d), cosines = dot3(m, d) * -dot3(k, d);
            if (cosines > 0 && !hidden(p, d)) sum += cosines / (M_PI * d2 * d2);
        }
    return sum / (double(n) * n * n * n);
}

}  // namespace gw::radiosity
