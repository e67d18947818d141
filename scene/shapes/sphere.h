// Spheres about the origin: of meridians and parallels, and of a divided icosahedron.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// 2 slices (stacks - 1) triangles; s round the y axis from +z over +x, t from pole to pole.
MeshData make_sphere(double radius, int slices, int stacks);

/// 20 * 4^divisions nearly equal triangles. s, t as above; triangles across the seam have s up to
/// 1.5 (maps repeat).
MeshData make_icosphere(double radius, int divisions);

}  // namespace gw::scene
