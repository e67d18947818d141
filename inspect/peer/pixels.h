// Clears, pixel rectangles, spans, copies, accumulation through OpenGL, and planes back to the
// host.
#pragma once

#include "gw/command_list.h"
#include "gw/planes.h"

namespace gw::peer {

void clear(const Clear& command);
void write(const WriteSpans& command);
void write(const WritePixels& command, const DepthState& depth);
void copy(const Copy& command, const DepthState& depth);

/// Mesa holds accumulated values in [-1, 1], 16 bits; the machine counts units of the frame buffer.
/// Weights of Accum, Load and Add are divided by 128 and Return's is multiplied by it, so that as
/// many pictures fit.
void accumulate(const Accumulate& command);

Planes read_planes(int width, int height);

}  // namespace gw::peer
