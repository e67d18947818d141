// A ray and a polygon. [L11] Does not know holes; concave polygons are taken as they are.
#pragma once

#include "raytrace/casting/inside_test.h"
#include "raytrace/casting/ray.h"

#include <optional>
#include <span>
#include <vector>

namespace gw::raytrace {

/// A plane polygon made ready: its normal, and the axis along which it is projected for the inside
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

/// t = (P_i - P_E).N / E.N; none where the ray is parallel to the plane. [L11]
std::optional<double> plane_parameter(const Ray& ray, const dvec3& point, const dvec3& normal);

/// Where the ray meets the polygon, t > 0.
std::optional<double> intersect(const Ray& ray, const PlanePolygon& polygon,
                                InsideTest test = InsideTest::Crossings);

struct Hit {
    std::size_t polygon = 0;
    double t = 0;
};

/// The nearest of all intersections [L9], found by testing every polygon; of polygons equally near
/// the first. None: the background.
std::optional<Hit> nearest_hit(const Ray& ray, std::span<const PlanePolygon> polygons);

}  // namespace gw::raytrace
