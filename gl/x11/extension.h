// What Xlib offers to extensions only: a call when the program closes a display, names of our own.
#pragma once

#include "gl/x11/x11.h"

namespace gw::gl::x11 {

using CloseHook = int (*)(Display* display, XExtCodes* codes);

/// Calls the hook in XCloseDisplay, while the connection is still open.
void call_at_close(Display* display, CloseHook hook);

/// A name that nothing else on the display has, out of the range that the server gave the program:
/// for our own drawables and contexts. Any thread may ask.
XID new_name(Display* display);

}  // namespace gw::gl::x11
