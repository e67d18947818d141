// Concave polygons as triangles. Does not know holes.
#pragma once

#include "irisgl/draw/primitives.h"

namespace gw::irisgl {

/// Triangles by cutting ears, with the polygon's orientation.
std::vector<Vertex> tessellated(std::span<const Vertex> polygon);

}  // namespace gw::irisgl
