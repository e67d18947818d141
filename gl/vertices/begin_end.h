// Adds vertices to the mesh that is being assembled, in place of Vertex: for arrays and evaluators.
#pragma once

#include "gl/assemble/assembly.h"

#include <span>

namespace gw::gl {

struct Context;

/// Not a finite position, or not between Begin and End: the vertex is dropped.
void add_vertex(Context& context, AssembledVertex v);
/// `further`: of each vertex, if units beside the first have textures.
void add_vertices(Context& context, std::span<const AssembledVertex> added,
                  std::span<const FurtherTexcoords> further);

}  // namespace gw::gl
