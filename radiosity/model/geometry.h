// Convex polygons in a plane: cut by a line or a box, their area and centroid. The nearest point of
// a triangle in space.
#pragma once

#include "gw/base/types.h"

#include <array>

namespace gw::radiosity {

/// Up to 12 corners: a triangle or quad cut by up to eight lines.
struct Polygon2 {
    std::array<dvec2, 12> p{};
    int n = 0;
    void add(const dvec2& q) { p[std::size_t(n++)] = q; }
    const dvec2& operator[](int i) const { return p[std::size_t(i)]; }
};

/// The part with p[axis] * sign >= limit * sign.
Polygon2 cut(const Polygon2& polygon, int axis, double limit, double sign);

/// The part with dot(side, (1, p)) >= 0.
Polygon2 cut(const Polygon2& polygon, const dvec3& side);

/// The part inside low .. high.
Polygon2 cut_to_box(const Polygon2& polygon, const dvec2& low, const dvec2& high);

/// Positive for either orientation.
double area(const Polygon2& polygon);
/// Of a polygon with an area.
dvec2 centroid(const Polygon2& polygon);

/// The point of a triangle that is nearest to p. The triangle has an area.
dvec3 nearest_point(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c);

}  // namespace gw::radiosity
