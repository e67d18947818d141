// Shapes about the origin, y up: counter-clockwise from outside, with normals of length 1 and
// texture coordinates. Vessels turned on a lathe are in lathe.h.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// A rectangle in the plane y = 0, facing up; s along x, t along -z.
MeshData make_rectangle(double width, double depth, int columns, int rows);

/// Six faces of segments x segments quads, each with s, t from 0 to 1, upright on the four sides.
MeshData make_box(dvec3 size, int segments);

/// A box whose faces look inwards.
MeshData make_room(dvec3 size, int segments);

/// A sphere of 2 slices (stacks - 1) triangles; s round the y axis from +z over +x, t from pole to
/// pole.
MeshData make_sphere(double radius, int slices, int stacks);

/// A sphere of 20 * 4^divisions nearly equal triangles. s, t as make_sphere has them; triangles
/// across the seam have s up to 1.5 (maps repeat).
MeshData make_icosphere(double radius, int divisions);

/// A disc in the plane y = 0, facing up, of `rings` rings. s, t lay a picture over it: s along x, t
/// along -z.
MeshData make_disc(double radius, int slices, int rings);

/// Side and, if `capped`, two discs, about the y axis; s once round the side, t up it.
MeshData make_cylinder(double radius, double height, int slices, int stacks, bool capped);

/// A cone with its tip up; s, t as make_cylinder has them.
MeshData make_cone(double radius, double height, int slices, int stacks, bool capped);

/// A ring about the y axis: `radius` is that of the circle in the plane y = 0 that the tube
/// follows, `tube` the tube's own. 2 segments sides triangles. s runs once round the ring, t once
/// round the tube.
MeshData make_torus(double radius, double tube, int segments, int sides);

/// A tube along the curve that goes p times round the y axis while it goes q times round a torus; a
/// knot if p and q have no common divisor. `radius` is that of the torus' circle; the torus' tube
/// has 0.4 of it. 2 segments sides triangles.
MeshData make_torus_knot(int p, int q, double radius, double tube, int segments, int sides);

/// The Utah teapot: 64 segments^2 - 8 segments triangles, standing on y = 0, spout along x, 3.15
/// high as published. s runs round body, lid, spout and handle. t runs up the body and the lid, and
/// along spout and handle.
MeshData make_teapot(int segments);

}  // namespace gw::scene
