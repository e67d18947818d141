// Translucent polygons in the order of their distance [K3.4]: the farthest centroid first. As
// painters do, and as wrong where polygons pierce each other or overlap in a cycle (docs/passes.md
// has a picture; layers.h is exact). Does not blend.
#pragma once

#include "multipass/frame/placed_model.h"

#include <vector>

namespace gw::multipass {

/// The triangles of all translucent parts, farthest centroid (along the line of sight) first, in
/// portions of neighbours that belong to one part. Those at equal distance keep the order of
/// objects and triangles.
std::vector<Portion> far_to_near(const Stage& stage);

}  // namespace gw::multipass
