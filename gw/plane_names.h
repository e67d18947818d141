// Planes and their values as people read them, in tables, files and messages. Does not compare
// planes.
#pragma once

#include "gw/planes.h"

#include <string>

namespace gw {

/// "color", "depth", "stencil", "accum"
const char* name_of(Plane plane);

/// Of one pixel of the window: "12 34 56 255" or "16777215".
std::string value_at(const Planes& planes, Plane plane, int x, int y);

}  // namespace gw
