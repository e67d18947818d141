// The exact side of a line that a point lies on. Coordinates are float32, so every product is exact
// in double. Does not compute a distance.
#pragma once

#include "gw/base/types.h"

namespace gw {

/// +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they are collinear or coincide.
/// Exact for all finite floats.
int orient(vec2 a, vec2 b, vec2 c);

}  // namespace gw
