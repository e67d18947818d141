// Rings: a torus about the y axis, and torus knots.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// `radius` of the circle in the plane y = 0 that the tube follows, `tube` its radius. 2 segments
/// sides triangles. s once round the ring, t once round the tube.
MeshData make_torus(double radius, double tube, int segments, int sides);

/// A tube along the curve that goes p times round the y axis while it goes q times round a torus; a
/// knot where p and q have no common divisor. `radius` of the torus' circle; its own tube is 0.4 of
/// that. 2 segments sides triangles.
MeshData make_torus_knot(int p, int q, double radius, double tube, int segments, int sides);

}  // namespace gw::scene
