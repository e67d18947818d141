// How much of each texel the figures cover [F2.1], and what a texel at a figure's border belongs to.
#pragma once

#include "radiosity/model.h"

namespace gw::radiosity {

/// Fills in area, rho, E and nearest of a model whose figures, facets and pixmaps are known. A texel of which
/// less than a 64th is covered gives that part to its nearest neighbour: a quotient by almost nothing is
/// noise. Throws Error where figures cover a texel twice.
void cover_texels(Model& model);

}  // namespace gw::radiosity
