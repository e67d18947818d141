// The scenes of the growth study, by number of polygons, depth complexity and the camera's turn. Does
// not measure.
#pragma once

#include "scene/scene.h"

namespace gw::study {

/// `count` triangles in all directions, about `depth` over each pixel. The camera is turned by
/// `degrees` around the middle.
scene::Scene triangle_soup(int count, double depth, double degrees);

/// Hills over a grid of about `count` cells. `height` is the eye's: a lower eye sees more hills hide
/// each other.
scene::Scene hill_grid(int count, double height, double degrees);

}  // namespace gw::study
