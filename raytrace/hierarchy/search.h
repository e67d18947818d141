// Searching a wide tree, behind run-time dispatch. Does not build.
#pragma once

#include "raytrace/hierarchy/hierarchy.h"

namespace gw::raytrace {

/// The nearest hit; triangle = no_polygon: none.
HierarchyHit search_nearest(const WideTree& tree, const HierarchyRay& ray) noexcept;
bool search_any(const WideTree& tree, const HierarchyRay& ray) noexcept;

}  // namespace gw::raytrace
