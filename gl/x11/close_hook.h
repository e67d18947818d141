// A call when the program closes a display.
#pragma once

#include "gl/x11/x11.h"

namespace gw::gl::x11 {

using CloseHook = int (*)(Display* display, XExtCodes* codes);

/// Calls the hook in XCloseDisplay, while the connection is still open.
void call_at_close(Display* display, CloseHook hook);

}  // namespace gw::gl::x11
