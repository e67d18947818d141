// Roberts' algorithm: L. G. Roberts, "Machine perception of three-dimensional solids", MIT Lincoln
// Laboratory TR 315, 1963. The first hidden-line algorithm: object space, every line against every
// body.
//
// A convex body is the points with u.V >= 0 for all columns of its volume matrix V: its planes.
// Lines between two faces that look away are dropped. A point s + t d of a line is hidden where
// some point s + t d + alpha g on its way to the eye (g, alpha > 0) is inside a body; Roberts finds
// the least and greatest t among the corners of the region of (t, alpha) where all columns agree.
// Here alpha is eliminated first: what is left is one inequality in t for each face that looks at
// the eye (the point is behind it) and for each side of the contour (inside it), and the hidden
// part is where all hold. A line has at most one hidden part per body.
//
// Claims: right for any polygons. Roberts has convex solids, and figures put together from them;
// here what is not a closed convex solid beyond the near plane is taken piece by piece, each plane
// convex piece a body without thickness. Solids may go through each other: the hidden parts are
// right, but the lines in which they do so are not drawn (Petty and Mach added them in 1977).
// Decides in the world, before the snap.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

LineAlgorithm roberts();

}  // namespace gw::hiddensurface
