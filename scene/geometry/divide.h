// Divides four-sided faces, so that lighting at the vertices [K Fig. 2] has vertices to light. Does
// not change other faces, and moves no vertex.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// Every quad, and every polygon of four corners, becomes pieces x pieces quads, bilinear between
/// its corners in position, normal, texcoord and colour; each is a polygon of its own. Two divided
/// faces with a common side have bit-equal points on it. The mesh must not have polygon_ids.
MeshData divide(MeshData mesh, int pieces);

/// The number of triangles that divide would make; other faces of n corners count as n - 2.
double divided_triangles(const MeshData& mesh, int pieces);

}  // namespace gw::scene
