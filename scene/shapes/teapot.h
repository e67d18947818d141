// The Utah teapot. Its control points are in teapot_data.h.
#pragma once

#include "gw/mesh.h"

namespace gw::scene {

/// 64 segments^2 - 8 segments triangles, standing on y = 0, spout along x, 3.15 high as published.
/// s runs round body, lid, spout and handle, t up the body and the lid and along spout and handle.
MeshData make_teapot(int segments);

}  // namespace gw::scene
