// Flat shapes of quads: a rectangle, a box, a room (a box seen from inside).
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// In the plane y = 0, facing up; s along x, t along -z.
MeshData make_rectangle(double width, double depth, int columns, int rows);

/// Six faces of segments x segments quads, each with s, t from 0 to 1, upright on the four sides.
MeshData make_box(dvec3 size, int segments);

/// The same facing inwards.
MeshData make_room(dvec3 size, int segments);

}  // namespace gw::scene
