// Translucent polygons by distance [K3.4]: the farthest centroid first. Wrong, as all sorting by
// centroids, where polygons pierce each other or overlap in a cycle (docs/passes.md); layers.h is
// exact. Does not blend.
#pragma once

#include "multipass/frame/placed_model.h"

#include <vector>

namespace gw::multipass {

/// The triangles of all translucent parts, farthest centroid (along the line of sight) first.
/// Successive triangles of one part make a portion. Triangles at equal distance keep the order of
/// objects and triangles.
std::vector<Portion> far_to_near(const PlacedModel& placed);

}  // namespace gw::multipass
