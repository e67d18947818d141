#include "raytrace/hierarchy/hierarchy.h"

#include "raytrace/hierarchy/build_tree.h"
#include "raytrace/hierarchy/search.h"

namespace gw::raytrace {

Hierarchy::Hierarchy(std::span<const HierarchyTriangle> triangles, int threads)
    : tree_(build_tree(triangles, threads)) {}

std::optional<HierarchyHit> Hierarchy::nearest(const HierarchyRay& ray) const {
    const HierarchyHit hit = search_nearest(tree_, ray);
    if (hit.triangle == no_polygon) return std::nullopt;
    return hit;
}

bool Hierarchy::occluded(const HierarchyRay& ray) const { return search_any(tree_, ray); }

}  // namespace gw::raytrace
