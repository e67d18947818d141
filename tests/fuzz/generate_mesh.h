// Meshes: triangles, lines and points in nasty places, with nasty attributes. Does not transform or
// light.
#pragma once

#include "gw/mesh.h"
#include "tests/fuzz/frame.h"

namespace gw::fuzz {

/// What the vertices of a mesh carry, and how depth varies over it.
struct MeshWish {
    bool normals = false, texcoords = false, colors = true;
    int most = 12;  ///< triangles, about
    bool flat_depth = false;
};

/// Any kind of triangle mesh: soups, slivers, strips, fans, quads, polygons, grids, twice the same
/// face.
MeshRef any_triangles(Random& random, const Frame& frame, const MeshWish& wish);
MeshRef any_lines(Random& random, const Frame& frame, const MeshWish& wish);
MeshRef any_points(Random& random, const Frame& frame, const MeshWish& wish);
/// Mostly triangles.
MeshRef any_mesh(Random& random, const Frame& frame, const MeshWish& wish);

/// Two triangles over the whole window and a little more or less, at depth z (Frame::deep says what
/// z is).
MeshRef cover_mesh(Random& random, const Frame& frame, const MeshWish& wish, double z);

/// The triangles of a mesh again, in other words: other primitives, orders, rotations; the same
/// pixels.
MeshRef same_faces(Random& random, const Mesh& mesh);

}  // namespace gw::fuzz
