#include "radiosity/model/geometry.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

dvec3 nearest_on_side(const dvec3& p, const dvec3& from, const dvec3& to) {
    const dvec3 side = to - from;
    return from + std::clamp(dot3(p - from, side) / dot3(side, side), 0.0, 1.0) * side;
}

double squared(const dvec3& v) { return dot3(v, v); }

}  // namespace

Polygon2 cut(const Polygon2& polygon, int axis, double limit, double sign) {
    Polygon2 inside;
    for (int i = 0; i < polygon.n; ++i) {
        const dvec2 &a = polygon[i], &b = polygon[i + 1 < polygon.n ? i + 1 : 0];
        const double da = (a[axis] - limit) * sign, db = (b[axis] - limit) * sign;
        if (da >= 0) inside.add(a);
        if ((da >= 0) == (db >= 0)) continue;
        dvec2 on = a + (b - a) * (da / (da - db));
        on[axis] = limit;
        inside.add(on);
    }
    return inside;
}

Polygon2 cut(const Polygon2& polygon, const dvec3& side) {
    Polygon2 inside;
    const auto height = [&](const dvec2& p) { return dot3(side, dvec3(1, p)); };
    for (int i = 0; i < polygon.n; ++i) {
        const dvec2 &a = polygon[i], &b = polygon[i + 1 < polygon.n ? i + 1 : 0];
        const double da = height(a), db = height(b);
        if (da >= 0) inside.add(a);
        if ((da >= 0) != (db >= 0)) inside.add(a + (b - a) * (da / (da - db)));
    }
    return inside;
}

Polygon2 cut_to_box(const Polygon2& polygon, const dvec2& low, const dvec2& high) {
    Polygon2 inside = polygon;
    for (int axis : {0, 1}) inside = cut(cut(inside, axis, low[axis], 1), axis, high[axis], -1);
    return inside;
}

double area(const Polygon2& polygon) {
    double twice = 0;
    for (int i = 2; i < polygon.n; ++i)
        twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return std::abs(twice) / 2;
}

dvec2 centroid(const Polygon2& polygon) {
    dvec2 sum(0);
    double twice = 0;
    for (int i = 2; i < polygon.n; ++i) {
        const dvec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
        const double t = cross(a, b);
        twice += t;
        sum += t * (a + b);
    }
    return polygon[0] + sum / (3 * twice);
}

dvec3 nearest_point(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 n = cross3(b - a, c - a);
    const auto outside = [&](const dvec3& from, const dvec3& to) {
        return dot3(cross3(n, to - from), p - from) < 0;
    };
    if (!outside(a, b) && !outside(b, c) && !outside(c, a))
        return p - (dot3(n, p - a) / dot3(n, n)) * n;
    dvec3 nearest = nearest_on_side(p, a, b);
    for (const dvec3& q : {nearest_on_side(p, b, c), nearest_on_side(p, c, a)})
        if (squared(p - q) < squared(p - nearest)) nearest = q;
    return nearest;
}

}  // namespace gw::radiosity
