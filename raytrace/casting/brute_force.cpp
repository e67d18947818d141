#include "raytrace/casting/brute_force.h"

namespace gw::raytrace {

std::optional<Hit> nearest_hit(const Ray& ray, std::span<const PlanePolygon> polygons) {
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto t = intersect(ray, polygons[i]);
        if (t && (!nearest || *t < nearest->t)) nearest = Hit{i, *t};
    }
    return nearest;
}

}  // namespace gw::raytrace
