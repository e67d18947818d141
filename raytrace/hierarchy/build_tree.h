// Building: triangles are halved by the surface area heuristic in bins (Wald 2007) until eight or
// fewer are left, and the binary tree is made wide by taking in the largest grandchildren (Wald,
// Benthin, Boulos 2008).
// Does not search.
#pragma once

#include "raytrace/hierarchy/hierarchy.h"

namespace gw::raytrace {

WideTree build_tree(std::span<const HierarchyTriangle> triangles, int threads);

}  // namespace gw::raytrace
