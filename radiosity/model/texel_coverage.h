// How much of each texel the figures cover [F2.1], and what a texel at a figure's border belongs
// to.
#pragma once

#include "radiosity/model/pixmap_model.h"

namespace gw::radiosity {

/// Fills in the model's texels; its figures, facets and pixmaps are there already. A texel of which
/// less than half is covered forms one element with its nearest neighbour: few pixels of an ID
/// buffer fall on it, and a quotient by almost nothing is noise. Throws Error where figures cover a
/// texel twice.
void cover_texels(PixmapModel& model);

}  // namespace gw::radiosity
