// One vertex for corners with the same values. Does not know lists or contexts.
#pragma once

#include "gw/mesh.h"

namespace gw::gl {

/// Corners whose values have the same bits use one vertex, in the order of first use. Changes
/// nothing, and returns false, for points and lines, or if more than half of the vertices would stay.
bool share_vertices(MeshData& mesh);

}  // namespace gw::gl
