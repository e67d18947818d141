// Vertex attributes other than positions. Does not place vertices.
#pragma once

#include "conformance/generate/mesh.h"

namespace gw::fuzz {

/// Fills the vertex arrays that `wish` names, and seldom polygon identifiers.
void add_attributes(Random& random, const MeshWish& wish, MeshData& data);

}  // namespace gw::fuzz
