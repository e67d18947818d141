// A recording through Mesa's OpenGL, beside the machine. Part of a build with OSMesa only.
#pragma once

#include "apps/recordings/machine_options.h"

#include <string>

namespace gw::apps {

/// A table: of every pass, how many pixels of colour, Z and stencil differ, and how
/// (inspect/compare/classify.h).
/// Says in its first line what played it. Lighting of two sides is switched off for both first, and
/// that is said. Throws Error where OpenGL cannot play it.
std::string compare_with_osmesa(inspect::Recording recording, const inspect::MachineMaker& make);

}  // namespace gw::apps
