#include "raytrace/tracer/crossing.h"

#include "gw/base/exact_sum.h"

#include <algorithm>
#include <cmath>

namespace gw::raytrace {
namespace {

using Difference = std::array<Sum, 3>;
/// Six products of three differences, each eight products of doubles, each four parts.
using Volume = ExactSum<6 * 8 * 4>;

Difference difference(const dvec3& a, const dvec3& b) {
    return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)};
}

void add_product(Volume& volume, double a, double b, double c) {
    if (a == 0 || b == 0 || c == 0) return;
    const Sum ab = two_product(a, b);
    for (const double part : {ab.lo, ab.hi}) {
        const Sum product = two_product(part, c);
        volume.add(product.lo);
        volume.add(product.hi);
    }
}

void add_product(Volume& volume, const Sum& a, const Sum& b, const Sum& c, int sign) {
    for (const double x : {a.lo, a.hi})
        for (const double y : {b.lo, b.hi})
            for (const double z : {c.lo, c.hi}) add_product(volume, sign * x, y, z);
}

/// (p - o) x (q - o) . d to a few units in the last place, its sign exact.
double exact_volume(const dvec3& o, const dvec3& p, const dvec3& q, const Difference& d) {
    const Difference a = difference(p, o), b = difference(q, o);
    Volume volume;
    for (std::size_t x = 0; x < 3; ++x) {
        const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
        add_product(volume, a[x], b[y], d[z], 1);
        add_product(volume, a[y], b[x], d[z], -1);
    }
    return volume.value();
}

Difference exactly(const dvec3& d) { return difference(d, dvec3(0)); }

/// A ray this steep to a plane meets it at a t that is right to 2^-40 of the largest coordinate: the
/// cosine of its angle, times the sine of the triangle's.
constexpr double steep = 0x1p-8;

}  // namespace

/// An edge function is a sum of six products of two differences and a component of the direction.
/// Each has at most 2^-50 of their largest value as its error.
CrossingTest::CrossingTest(const Ray& ray, double size) : ray_(ray) {
    const dvec3 o = abs(ray.origin), d = abs(ray.direction);
    const double far = size + std::max({o.x, o.y, o.z});
    rounding_ = 0x1p-48 * far * far * ((d.x + d.y) + d.z);
}

/// On which side of the line through p and q the ray goes; 0: it starts on that line.
int CrossingTest::exact_side(const dvec3& p, const dvec3& q) const {
    for (const dvec3& d : {ray_.direction, dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)})
        if (const double side = exact_volume(ray_.origin, p, q, exactly(d)); side != 0)
            return side > 0 ? 1 : -1;
    return 0;
}

bool CrossingTest::goes_through(const std::array<dvec3, 3>& corner) const {
    const dvec3 a = corner[0] - ray_.origin, b = corner[1] - ray_.origin,
                c = corner[2] - ray_.origin;
    const double u = dot3(cross3(b, c), ray_.direction), v = dot3(cross3(c, a), ray_.direction),
                 w = dot3(cross3(a, b), ray_.direction);
    const double least = std::min({u, v, w}), most = std::max({u, v, w});
    if (least > rounding_ || most < -rounding_) return true;
    if (least < -rounding_ && most > rounding_) return false;
    const int side = exact_side(corner[1], corner[2]);
    return side != 0 && side == exact_side(corner[2], corner[0]) &&
           side == exact_side(corner[0], corner[1]);
}

std::optional<Crossing> CrossingTest::cross(const std::array<dvec3, 3>& corner) const {
    if (!goes_through(corner)) return std::nullopt;
    const dvec3 &o = corner[0], e = corner[1] - o, f = corner[2] - o;
    const dvec3& d = ray_.direction;
    dvec3 normal = cross3(e, f);
    double slope = dot3(normal, d), height = dot3(normal, o - ray_.origin);
    if (slope * slope < steep * steep * (dot3(e, e) * dot3(f, f) * dot3(d, d))) {
        for (int k = 0; k < 3; ++k) {
            dvec3 axis(0);
            axis[k] = 1;
            normal[k] = exact_volume(o, corner[1], corner[2], exactly(axis));
        }
        slope = exact_volume(o, corner[1], corner[2], exactly(d));
        height = exact_volume(o, corner[1], corner[2], difference(o, ray_.origin));
    }
    if (slope == 0) return std::nullopt;
    return Crossing{height / slope, normal, height};
}

}  // namespace gw::raytrace
