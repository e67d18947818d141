// Plays a recording on Mesa's OpenGL and on the machine. Only in builds with OSMesa.
#pragma once

#include "apps/recordings/machine_options.h"

#include <string>

namespace gw::apps {

/// A table of the pixels of colour, Z and stencil that differ after each pass, by kind
/// (inspect/compare/classify.h). Its first line names OpenGL's renderer. Two-sided lighting is
/// switched off in both first; the first line then says so. Throws Error if OpenGL cannot play it.
std::string compare_with_osmesa(inspect::Recording recording, const inspect::MachineMaker& make);

}  // namespace gw::apps
