// pick and gselect: drawing without a picture, through OpenGL's selection.
#pragma once

#include "gw/base/types.h"

namespace gw::irisgl {

/// Multiplies projections while the program picks: the picking region is the whole volume.
const dmat4& picking_matrix();

}  // namespace gw::irisgl
