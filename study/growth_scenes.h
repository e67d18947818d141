// The scenes of the growth study: of so many polygons, so deep, seen from so far turned. Does not
// measure.
#pragma once

#include "scene/scene.h"

namespace gw::study {

/// `count` triangles of all directions, so large that about `depth` lie over each pixel; the camera
/// turned by so many degrees around the middle.
scene::Scene triangle_soup(int count, double depth, double degrees);

/// Hills over a grid of about `count` cells; `height` of the eye: the lower, the more hills hide
/// each other.
scene::Scene hill_grid(int count, double height, double degrees);

}  // namespace gw::study
