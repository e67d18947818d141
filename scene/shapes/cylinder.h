// Cylinders, cones and discs about the y axis.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// In the plane y = 0, facing up, in `rings` rings. s, t lay a picture over it: s along x, t along
/// -z.
MeshData make_disc(double radius, int slices, int rings);

/// Side and, where `capped`, two discs; s once round the side, t up it.
MeshData make_cylinder(double radius, double height, int slices, int stacks, bool capped);

/// The same with its tip up.
MeshData make_cone(double radius, double height, int slices, int stacks, bool capped);

}  // namespace gw::scene
