// Identifiers of polygons, unique over a whole scene, for item buffers [K4i].
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// Numbers the mesh's polygons (faces, segments, points) next, next + 1, ... in their order, moves
/// `next` behind them and makes the mesh. Throws Error as make_mesh does.
MeshRef make_numbered_mesh(MeshData data, std::uint32_t& next);

}  // namespace gw::scene
