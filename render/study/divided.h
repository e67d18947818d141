// A scene whose triangles are divided into four, again and again: the same surfaces of more polygons,
// for studies of their number. Does not smooth.
#pragma once

#include "scene/scene.h"

namespace gw::render {

/// Each triangle becomes 4^times triangles, by the middles of its sides; each is a polygon of its own.
/// Triangles with a common side have bit-equal points on it. Points and lines stay. Once at least,
/// polygons of more corners become triangles too. Throws Error if a mesh gets too large.
scene::Scene divided(scene::Scene scene, int times);

}  // namespace gw::render
