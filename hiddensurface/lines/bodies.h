// The convex bodies with which Roberts' algorithm compares lines. A closed convex solid is one body;
// every other plane convex piece of a polygon is a (flat) body by itself. Does not compare.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

/// A side of a polygon in the world.
struct WorldSide {
    dvec3 p, q;
    std::uint32_t id = 0;
    std::size_t solid = 0;  ///< 1 + the number of its solid; 0: none
    bool back = false;      ///< both faces of the solid look away
};

/// Hides all points on the positive side of all its planes. `planes`: those of faces that look at
/// the eye (behind them), and those through the eye and the contour (inside it); normals of length
/// 1.
struct Body {
    std::vector<dvec4> planes;
    std::size_t solid = 0;  ///< as WorldSide::solid
};

struct Bodies {
    std::vector<Body> bodies;
    std::vector<WorldSide> sides;
    double tolerance = 0;  ///< points nearer than this to a plane are on it
};
/// Counts facings.
Bodies bodies_of(const Input& input, LineCounts& counts);

}  // namespace gw::hiddensurface
