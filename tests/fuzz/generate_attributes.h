// What vertices carry besides positions. Does not place them.
#pragma once

#include "tests/fuzz/generate_mesh.h"

namespace gw::fuzz {

/// Fills the vertex arrays that `wish` names, and seldom polygon identifiers.
void add_attributes(Random& random, const MeshWish& wish, MeshData& data);

}  // namespace gw::fuzz
