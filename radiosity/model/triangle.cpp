#include "radiosity/model/triangle.h"

#include <algorithm>

namespace gw::radiosity {
namespace {

dvec3 nearest_on_side(const dvec3& p, const dvec3& from, const dvec3& to) {
    const dvec3 side = to - from;
    return from + std::clamp(dot3(p - from, side) / dot3(side, side), 0.0, 1.0) * side;
}

double squared(const dvec3& v) { return dot3(v, v); }

}  // namespace

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
