// The side of a line that a point lies on, decided exactly. Coordinates are float32, so that every
// product is exact in double. Does not say how far away the point is.
#pragma once

#include "gw/base/types.h"

namespace gw {

/// +1 where a, b, c turn counter-clockwise, -1 where clockwise, 0 where they are collinear or
/// coincide. Exact for all finite floats.
int orient(vec2 a, vec2 b, vec2 c);

}  // namespace gw
