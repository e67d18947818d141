// A scene for rays: its triangles in world space, and hierarchies over all of them and over those
// that cast shadows. Made once for all views. Does not shade.
//
// The hierarchy excludes in float32 the triangles that no rounding could let a ray meet. The rest
// is decided without rounding (crossing.h). So on every path through a closed body entering and
// leaving alternate: no ray loses the triangle next to the one that it starts from, or meets it
// twice.
#pragma once

#include "raytrace/hierarchy/hierarchy.h"
#include "raytrace/ray.h"
#include "scene/draw/world_triangles.h"

#include <optional>

namespace gw::raytrace {

/// Points and lines meet no ray.
class World {
public:
    /// `threads` as in parallel_for.
    explicit World(const scene::Scene& scene, int threads = 0);

    const scene::WorldTriangles& triangles() const { return triangles_; }

    /// The nearest triangle that the ray meets at 0 < t < high. `from`: the triangle that it starts
    /// from (Surface::start), which it does not meet again. The point is on the triangle's plane,
    /// in double. Adds the search's work to `counts` unless it is null.
    std::optional<scene::TrianglePoint> nearest(const Ray& ray, double high,
                                                std::uint32_t from = no_triangle,
                                                SearchCounts* counts = nullptr) const;
    /// Whether the ray meets a triangle that casts a shadow.
    bool occluded(const Ray& ray, double high, std::uint32_t from,
                  SearchCounts* counts = nullptr) const;

    const Hierarchy& hierarchy() const { return all_; }

private:
    scene::WorldTriangles triangles_;
    Hierarchy all_;
    std::optional<Hierarchy> casting_;  ///< none: all cast
    std::vector<bool> single_sided_;    ///< by object; empty: none is
    double size_ = 0;                   ///< the largest coordinate, world units
};

/// The triangles as the hierarchy takes them: float32, numbered as they come.
std::vector<HierarchyTriangle> hierarchy_triangles(const scene::WorldTriangles& triangles);

}  // namespace gw::raytrace
