// Three tests whether a point lies in a plane polygon [L11]. They agree on convex polygons, except
// for points exactly on a side. Elsewhere they differ:
//
//                   concave                     crossing itself (a region around which it winds w times)
//   crossings       as filled by its border     inside where w is odd
//   cross products  inside only where every     inside only where every side is passed on the same hand
//                   side is passed on the
//                   same hand: its kernel
//   angles          as filled by its border     inside where w is not 0
//
// Does not intersect rays with planes (intersect_polygon.h does).
#pragma once

#include "gw/base/types.h"

#include <span>

namespace gw::raytrace {

enum class InsideTest { Crossings, CrossProducts, Angles };

/// Whether the half-line from `p` to growing x crosses the sides an odd number of times. A side
/// owns its lower end and not its upper one's row, so that a corner on the half-line counts once or
/// twice, as it must; points on left and top sides are inside, on right and bottom sides outside:
/// the machine's fill rule. Exact where coordinates are integers of at most 25 bits.
bool inside_by_crossings(const dvec2& p, std::span<const dvec2> corners);

/// Whether p lies on the same hand of all sides, on a side's line included.
bool inside_by_cross_products(const dvec2& p, std::span<const dvec2> corners);

/// Whether the angles under which p sees the sides, with their signs, sum to 2 pi or more instead
/// of 0. On a side or a corner: inside.
bool inside_by_angles(const dvec2& p, std::span<const dvec2> corners);

bool inside(InsideTest test, const dvec2& p, std::span<const dvec2> corners);

}  // namespace gw::raytrace
