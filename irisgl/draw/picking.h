// pick, gselect and feedback: drawing without a picture, through OpenGL's selection and feedback.
#pragma once

#include "gw/base/types.h"

namespace gw::irisgl {

/// Multiplies projections while the program picks: the picking region is the whole volume.
const dmat4& picking_matrix();
/// Whether a pick or gselect has begun.
bool picks();
bool gives_feedback();
/// In feedback: cmov moved here, in pixels and depths of IRIS GL.
void mark_character(const dvec3& at);

}  // namespace gw::irisgl
