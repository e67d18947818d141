// A scene for rays: its triangles in world space, and hierarchies over all of them and over those
// that cast shadows. Made once for all views. Does not shade.
#pragma once

#include "raytrace/casting/ray.h"
#include "raytrace/hierarchy/hierarchy.h"
#include "scene/geometry/world_triangles.h"

#include <optional>

namespace gw::raytrace {

/// Points and lines meet no ray.
class World {
public:
    /// `threads` as in parallel_for.
    explicit World(const scene::Scene& scene, int threads = 0);

    const scene::WorldTriangles& triangles() const { return triangles_; }

    /// Where the ray meets the nearest triangle at 0 < t < high. `from`: the polygon that it starts
    /// from, which it does not meet again; nor what lies within the rounding of positions around
    /// its start. The point is on the triangle's plane, in double.
    std::optional<scene::TrianglePoint> nearest(const Ray& ray, double high,
                                                std::uint32_t from = no_polygon) const;
    /// Whether anything that casts a shadow lies there.
    bool occluded(const Ray& ray, double high, std::uint32_t from) const;

    const Hierarchy& hierarchy() const { return all_; }

private:
    HierarchyRay hierarchy_ray(const Ray& ray, double high, std::uint32_t from) const;

    scene::WorldTriangles triangles_;
    Hierarchy all_;
    std::optional<Hierarchy> casting_;  ///< none: all cast
    /// what lies nearer to a ray's start, world units, is not met
    double skin_ = 0;
};

/// The triangles as the hierarchy takes them: float32, polygons by their identifiers.
std::vector<HierarchyTriangle> hierarchy_triangles(const scene::WorldTriangles& triangles);

}  // namespace gw::raytrace
