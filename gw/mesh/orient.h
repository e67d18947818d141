// The exact side of a line that a point lies on. Coordinates are float32, so every product is exact
// in double. Does not compute a distance.
#pragma once

#include "gw/base/types.h"

#include <cmath>

namespace gw {

/// +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they are collinear or coincide.
/// Exact for all finite floats.
int orient(vec2 a, vec2 b, vec2 c);

/// Whether they turn counter-clockwise by more than the rounding errors of doubles.
inline bool turns_left(vec2 a, vec2 b, vec2 c) {
    const dvec2 u = dvec2(b) - dvec2(a), v = dvec2(c) - dvec2(a);
    const double left = u.x * v.y, right = u.y * v.x;
    // Each product has three roundings of 2^-53 and their difference one more: 4 would suffice.
    return left - right > 8 * 0x1p-53 * (std::abs(left) + std::abs(right));
}

}  // namespace gw
