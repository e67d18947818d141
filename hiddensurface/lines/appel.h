// Appel's quantitative invisibility: A. Appel, "The notion of quantitative invisibility and the
// machine rendering of solids", Proc. ACM National Conference 1967, pp. 387-393.
//
// The quantitative invisibility of a point is the number of faces that hide it; a line is visible
// where it is
// 0. Along a line the number changes only where the line passes behind a contour: a side beyond which more or
// fewer faces lie than before it. From one line of a connected figure to the next it is carried
// over at the common corner, where only the faces at that corner have to be asked. So all faces are
// counted for one line of a figure, and for the others only contours are crossed.
//
// Claims: right for any faces, open or closed, convex or not. Appel has no faces that go through
// each other; here a line's places where it goes through a face are found as well (a line against
// every face whose box meets its own), and the number changes there too. Where a contour runs
// exactly through a corner or along a line in the window the number cannot be carried; that line is
// compared with every face (`starts`).
// Does not draw the lines in which faces go through each other: no polygon has them as a side.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

LineAlgorithm appel();

}  // namespace gw::hiddensurface
