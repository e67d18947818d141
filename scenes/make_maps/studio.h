// Surroundings for reflection maps: the picture of a mirror ball from afar [K3].
#pragma once

#include "scenes/make_maps/paint.h"

namespace gw::maps {

/// GL's sphere map of a photographer's studio: s, t is where the ball's normal points, as the eye
/// sees it. Dark, with a soft box above, a window with bars to the left, a row of lamps to the
/// right, a floor.
Color studio(dvec2 st);

/// The same of a landscape: sky, sun behind the eye's left shoulder, hills, ground.
Color landscape(dvec2 st);

}  // namespace gw::maps
