// Four-sided faces in pieces, so that lighting at the vertices [K Fig. 2] has vertices to be
// computed at.
// Does not touch other faces, and moves nothing.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// Every quad, and every polygon of four corners, becomes pieces x pieces quads, bilinear between
/// its corners in position, normal, texcoord and colour; each is a polygon of its own. Faces that
/// share a side still share its points, bit for bit, where both are divided. The mesh must not have
/// polygon_ids.
MeshData divide(MeshData mesh, int pieces);

}  // namespace gw::scene
