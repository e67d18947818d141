// A map from a function of s and t. Does not write files.
#pragma once

#include "gw/base/types.h"
#include "image/picture.h"

namespace gw::maps {

using Color = dvec3;  ///< R, G, B in 0 .. 1, clamped

/// width x height texels of 8 bits, each the mean of 4x4 points of at(s, t).
image::Picture paint(int width, int height, Color (*at)(dvec2 st));

Color mix(Color a, Color b, double t);           ///< t clamped to 0 .. 1
double ramp(double low, double high, double x);  ///< 0 below low, 1 above high, straight between
Color grey(double v);

}  // namespace gw::maps
