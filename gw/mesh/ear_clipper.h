// Ear clipping. G. H. Meisters, "Polygons have ears", American Mathematical Monthly 82 (1975): a
// polygon that does not cross itself has a corner that can be cut off. Does not treat convex
// polygons apart: triangulate.h does.
#pragma once

#include "gw/mesh/triangulate.h"

namespace gw {

/// n - 2 triangles of a counter-clockwise polygon of n > 3 corners; their `edges` are left 0.
std::vector<PolygonTriangle> clip_ears(std::span<const vec2> corners);

}  // namespace gw
