// Names of our own drawables and contexts, out of the range that the server gave the program.
#pragma once

#include "gl/x11/x11.h"

namespace gw::gl::x11 {

/// A name that nothing else on the display has. Any thread may ask.
XID new_name(Display* display);

}  // namespace gw::gl::x11
