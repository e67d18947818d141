// Selection and feedback: a draw's vertices after clipping, and the names that are current, are
// written to the caller's memory. [GL11] 5.2, 5.3. Nothing is drawn meanwhile.
#pragma once

#include "gw/command_list.h"

#include <GL/gl.h>

namespace gw::gl {

struct Context;

/// Runs the vertex and clip stages on a draw's primitives and writes what selection or feedback
/// asks for.
void report(Context& context, const Draw& draw);

/// In feedback mode, writes a token and the raster position.
void report_raster_position(Context& context, GLenum token);

/// Counts a hit at a window depth of the raster position.
void report_depth(Context& context, double depth);

}  // namespace gw::gl
