// Pixels of the drawable, for ReadPixels and for copies into textures.
#pragma once

#include "gl/drawable/frame_log.h"
#include "gw/base/types.h"
#include "gw/machine.h"
#include "gw/planes.h"

#include <vector>

namespace gw::gl {

struct Context;

/// The part of a rectangle that lies in what is read; its area may be 0. The context has a drawable.
Rect part_inside(const Context& context, const Rect& rect);

/// Colours 0 .. 1, bottom row first; 0 outside.
std::vector<vec4> read_colors(Context& context, const Rect& rect, Cause cause);
/// The same after transfer, quantized to `bits` bits.
std::vector<Rgba> read_rgba(Context& context, const Rect& rect, Cause cause, int bits);
/// A rectangle inside, as the machine has it. The context has a drawable.
Readback read_raw(Context& context, Plane plane, const Rect& rect);
/// Depths 0 .. 1, or stencil values.
std::vector<double> read_values(Context& context, Plane plane, const Rect& rect, Cause cause);

}  // namespace gw::gl
