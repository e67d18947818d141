// Polygons of which a machine shows pixels from behind: thin triangles that rounding turns around. Does
// not draw.
#pragma once

#include "scene/draw/view.h"
#include "scene/scene.h"

#include <string>

namespace gw::scene {

/// Names the first polygon of five corners or more with a triangle that turns around in the snap
/// (R6.21, R6.23) and covers a pixel; empty: none does.
std::string turned_slivers(const Scene& scene, const View& view, int subpixel_bits);

}  // namespace gw::scene
