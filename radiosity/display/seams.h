// Where the charts of a curved figure meet [F2.3]. Display only: nothing is computed with it.
#pragma once

#include "radiosity/display/displayed_pixmaps.h"

namespace gw::radiosity {

/// Finds the colours of texels that figures cover in part, or not at all, if a smooth surface goes on
/// there in another pixmap. Both pixmaps' elements around the texel's middle, each at the middle of
/// what it covers, are fitted by a paraboloid: so both show the same colours along the border. Surfaces
/// that bend by 40 degrees or more there are left alone.
void close_seams(const PixmapModel& model, DisplayedPixmaps& colors);

}  // namespace gw::radiosity
