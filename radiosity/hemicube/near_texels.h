// Texels that are large in the eye of a hemicube's point: in closed form, and divided where the ID
// buffers show only a part [F2.2o]. Scalar.
#pragma once

#include "radiosity/hemicube/figure_view.h"

namespace gw::radiosity {

/// The light that a near texel of a figure receives, (u, v) its lower left corner.
double near_factor(const FigureView& view, const PlaneFigure& figure, const SeenIds& seen, int u,
                   int v);

}  // namespace gw::radiosity
