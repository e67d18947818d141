// Texels that are large in the eye of a hemicube's point: in closed form, and divided where the ID
// buffers show only a part [F2.2o]. Texels beside a part of a patch, without a hemicube. Scalar.
#pragma once

#include "radiosity/hemicube/figure_view.h"
#include "radiosity/model/near_parts.h"

namespace gw::radiosity {

/// The light that a near texel of a figure receives, (u, v) its lower left corner.
double near_factor(const FigureView& view, const PlaneFigure& figure, const SeenIds& seen, int u,
                   int v);

/// The form factor from a part of a patch to the near texel (u, v), of which nothing is hidden. In
/// closed form from points that are as far apart as the texel is away.
double near_factor(const PixmapModel& model, const NearPart& part, const NearTexels& texels, int u,
                   int v);

}  // namespace gw::radiosity
