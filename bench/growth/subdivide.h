// Meshes of four times as many triangles, the same surface. Does not smooth.
#pragma once

#include "gw/mesh.h"

namespace gw::growth {

/// Every triangle cut in four at its sides' middles, which neighbours share. Positions, normals and
/// texture coordinates are averaged; polygons become their triangles.
MeshRef subdivided(const Mesh& mesh);

}  // namespace gw::growth
