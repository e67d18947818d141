// The file of GW_INPUT: events for programs without a hand at the mouse.
#pragma once

#include "irisgl/state/events.h"

namespace gw::irisgl {

/// Lines "frame 3 LEFTMOUSE down 100 200": before frame 3 is drawn, in pixels of the window; a value
/// is down, up, a number, or a character for KEYBD. A wrong line is reported and left out.
std::deque<ScriptedEvent> read_script();

}  // namespace gw::irisgl
