// The nearest of all intersections, found by asking every polygon. [L9] Does not accelerate
// anything.
#pragma once

#include "raytrace/casting/intersect_polygon.h"

namespace gw::raytrace {

struct Hit {
    std::size_t polygon = 0;
    double t = 0;
};

/// Of polygons equally near the first. None: the background.
std::optional<Hit> nearest_hit(const Ray& ray, std::span<const PlanePolygon> polygons);

}  // namespace gw::raytrace
