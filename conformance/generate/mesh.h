// Meshes: triangles, lines and points at positions and with attributes that are hard to draw
// exactly. Does not transform or light.
#pragma once

#include "conformance/generate/frame.h"
#include "gw/mesh.h"

namespace gw::conformance {

/// The attributes of a mesh and its depths.
struct MeshWish {
    bool normals = false, texcoords = false, colors = true;
    int most = 12;  ///< approximate maximum of triangles
    bool flat_depth = false;
};

/// Any kind of triangle mesh: soups, slivers, strips, fans, quads, polygons, grids, repeated faces.
MeshRef any_triangles(Random& random, const Frame& frame, const MeshWish& wish);
MeshRef any_lines(Random& random, const Frame& frame, const MeshWish& wish);
MeshRef any_points(Random& random, const Frame& frame, const MeshWish& wish);
/// Mostly triangles.
MeshRef any_mesh(Random& random, const Frame& frame, const MeshWish& wish);

/// Two triangles over about the whole window at depth z, by Frame::deep.
MeshRef cover_mesh(Random& random, const Frame& frame, const MeshWish& wish, double z);

/// A quad from its lower left to its upper right corner, z = 0, without attributes.
MeshData rectangle(float left, float bottom, float right, float top);

/// A mesh of the same pixels by other primitives, in another order, with rotated vertices.
MeshRef same_faces(Random& random, const Mesh& mesh);

}  // namespace gw::conformance
