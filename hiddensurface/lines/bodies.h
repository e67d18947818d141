// Convex bodies of a scene, as what Roberts' algorithm compares lines with: a closed convex solid
// is one body; every other plane convex piece of a polygon is a (flat) body by itself. Does not
// compare.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

/// A side of a polygon in the world.
struct WorldSide {
    dvec3 p, q;
    std::uint32_t id = 0;
    std::size_t solid = 0;  ///< 1 + the number of the solid it is a side of; 0: of none
    bool back = false;      ///< of a solid, both faces look away
};

/// Hides what lies on the positive side of all its planes. `planes`: of faces that look at the eye
/// (behind them), and through the eye and the contour (inside it); normals of length 1.
struct Body {
    std::vector<dvec4> planes;
    std::size_t solid = 0;  ///< as WorldSide::solid
};

struct Bodies {
    std::vector<Body> bodies;
    std::vector<WorldSide> sides;
    double tolerance = 0;  ///< nearer than this to a plane is on it
};
/// Counts facings.
Bodies bodies_of(const Input& input, LineCounts& counts);

}  // namespace gw::hiddensurface
