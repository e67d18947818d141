// Intersections of a ray with a polygon [L11], a sphere [L10] and a box [L12], in double. Does not
// know scenes.
#pragma once

#include "gw/base/types.h"
#include "raytrace/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace gw::raytrace {

/// Three tests whether a point lies in a plane polygon [L11]. They agree on convex polygons, except
/// for points exactly on a side. On other polygons they differ:
///
///                   concave                     crossing itself (a region around which it winds w times)
///   crossings       as filled by its border     inside where w is odd
///   cross products  inside only if every        inside only if every side is passed on the same hand
///                   side is passed on the
///                   same hand: its kernel
///   angles          as filled by its border     inside where w is not 0
enum class InsideTest { Crossings, CrossProducts, Angles };

/// What one side from a to b adds to each of the tests of a point p: whether the half-line from p to
/// growing x crosses it,
bool crosses(const dvec2& p, const dvec2& a, const dvec2& b);
/// the cross product of the side and the way to p, positive if p is on its left,
double side_product(const dvec2& p, const dvec2& a, const dvec2& b);
/// and the angle under which p sees it, with its sign; none: p is on the side.
std::optional<double> seen_angle(const dvec2& p, const dvec2& a, const dvec2& b);

/// Whether the half-line from `p` to growing x crosses the sides an odd number of times. A side
/// owns its lower end and not its upper one's row, so that a corner on the half-line counts once or
/// twice, as it must. Points on left and top sides are inside, on right and bottom sides outside:
/// the machine's fill rule. Exact if coordinates are integers of at most 25 bits.
bool inside_by_crossings(const dvec2& p, std::span<const dvec2> corners);

/// Whether p lies on the same hand of all sides, on a side's line included.
bool inside_by_cross_products(const dvec2& p, std::span<const dvec2> corners);

/// Whether the angles under which p sees the sides, with their signs, sum to 2 pi or more instead
/// of 0. On a side or a corner: inside.
bool inside_by_angles(const dvec2& p, std::span<const dvec2> corners);

bool inside(InsideTest test, const dvec2& p, std::span<const dvec2> corners);

/// A plane polygon without holes, convex or concave, made ready: its normal, and the axis along which it is projected for the inside
/// test.
struct PlanePolygon {
    std::vector<dvec3> corners;
    dvec3 normal{0};  ///< of any length
    int axis = 2;     ///< 0, 1, 2: x, y, z is left out; the normal is not 0 along it
};

/// The normal is the sum of the corners' cross products, the axis the one along which it is
/// longest.
PlanePolygon plane_polygon(std::vector<dvec3> corners);
/// The same with an axis that is given: rays along it meet the projection exactly.
PlanePolygon plane_polygon(std::vector<dvec3> corners, int axis);

/// t = (P_i - P_E).N / E.N; none if the ray is parallel to the plane. [L11]
std::optional<double> plane_parameter(const Ray& ray, const dvec3& point, const dvec3& normal);

/// The t > 0 at which the ray meets the polygon.
std::optional<double> intersect(const Ray& ray, const PlanePolygon& polygon,
                                InsideTest test = InsideTest::Crossings);

struct Hit {
    std::size_t polygon = 0;
    double t = 0;
};

/// The nearest of all intersections [L9], found by testing every polygon; of polygons equally near
/// the first. None: the background.
std::optional<Hit> nearest_hit(const Ray& ray, std::span<const PlanePolygon> polygons);

struct Sphere {
    dvec3 center{0};  ///< S
    double radius = 1;
};

/// The t > 0, in lengths of the direction, at which the ray enters the sphere, or leaves it if it
/// starts inside. With |E| = 1: t^2 + 2 b t + c = 0, b = E.(P_E - S), c = |P_E - S|^2 - r^2; real if
/// b^2 - c >= 0. [L10]
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

/// An axis-aligned box: the lecture's bounding volume [L12]. Box3 is the fast hierarchy's, in
/// float32.
struct Box {
    dvec3 low{std::numeric_limits<double>::infinity()},
        high{-std::numeric_limits<double>::infinity()};

    void add(const dvec3& p) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    void add(const Box& b) {
        add(b.low);
        add(b.high);
    }
};

/// The part of the ray that is in the box, cut at t = 0, by slabs. The box is taken a little larger,
/// so that rounding loses nothing that lies in its faces.
struct Interval {
    double from = 0, to = 0;
};
inline std::optional<Interval> through(const Box& box, const Ray& ray) {
    Interval in{0, std::numeric_limits<double>::infinity()};
    for (int k = 0; k < 3; ++k) {
        const double slack =
            1e-12 * (std::max(std::abs(box.low[k]), std::abs(box.high[k])) + 1e-300);
        const double low = box.low[k] - slack, high = box.high[k] + slack;
        if (ray.direction[k] == 0) {
            if (ray.origin[k] < low || ray.origin[k] > high) return std::nullopt;
            continue;
        }
        const double a = (low - ray.origin[k]) / ray.direction[k],
                     b = (high - ray.origin[k]) / ray.direction[k];
        in.from = std::max(in.from, std::min(a, b));
        in.to = std::min(in.to, std::max(a, b));
    }
    if (in.from > in.to * (1 + 1e-12)) return std::nullopt;
    return in;
}

}  // namespace gw::raytrace
