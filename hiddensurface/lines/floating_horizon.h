// The floating horizon: H. Williamson, "Algorithm 420: Hidden-line plotting program", CACM 15(2),
// 1972; T. J.
// Wright, "A two-space solution to the hidden line problem for plotting functions of two
// variables", IEEE Trans. Computers C-22(1), 1973. The cells in order from near to far as in D. P.
// Anderson, "Hidden line elimination in projected grid surfaces", ACM Trans. Graphics 1(4), 1982.
//
// Of a surface y = f(x, z) the lines are drawn from near to far. What has been drawn covers, in
// every column of the picture, all from its lowest to its highest point: a farther line is visible
// above the upper horizon and below the lower one, and then it is the horizon. Williamson keeps the
// horizon as pieces of lines, Wright as a height for each column of the plotter; here it is
// Williamson's. Heights are compared on a picture plane that stands upright along the rows, where
// the horizons are functions; what is seen does not depend on the plane, so the camera may be
// turned in any way.
//
// Claims: right for a height field (every cell of a grid along x and z covered once by a
// quadrilateral or two triangles; a bent quadrilateral as the two triangles that the machine
// draws), seen from an eye that is not above it: outside its extent in x or in z. Other scenes are
// refused. Decides in the world, before the snap.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

LineAlgorithm floating_horizon();

}  // namespace gw::hiddensurface
