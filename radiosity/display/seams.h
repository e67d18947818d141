// Where a smooth surface goes on in another pixmap, as from chart to chart of a sphere, texels at
// the border show what the other one does, so that no seam is seen [F2.3]. Display only: nothing is
// computed with it.
#pragma once

#include "radiosity/display/displayed_pixmaps.h"

namespace gw::radiosity {

/// Texels that figures cover in part, or not at all, next to their pixmap's border: their uncovered
/// share takes the colour of the same object's nearest point in another pixmap, where the surface
/// bends by less than 40 degrees between the two and is no farther than a texel.
void close_seams(const PixmapModel& model, DisplayedPixmaps& colors);

}  // namespace gw::radiosity
