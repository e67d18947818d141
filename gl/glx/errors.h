// X errors that GLX's functions raise.
#pragma once

#include "gl/glx/glx.h"

namespace gw::gl::glx {

/// [GLX 1.4] 3.5: errors that GLX adds to the core's, counted from the extension's error base.
/// Their names without "GLXBad".
enum class GlxError {
    Context,
    ContextState,
    Drawable,
    Pixmap,
    FBConfig = 9,
    Pbuffer,
    CurrentDrawable,
    Window,
    Profile
};

/// The numbers of GLX on a display. If the server has no GLX, numbers that its other extensions
/// hardly have.
struct ExtensionCodes {
    int request = 0, event_base = 0, error_base = 0;
};
/// Once for each display: has Xlib print them as names too.
ExtensionCodes register_codes(Display* display);

/// Gives the program's X error handler an error of the core (BadMatch) or of GLX. The error names
/// the GLX request of this number (X_GLXMakeCurrent).
void send_error(Display* display, int core_error, XID resource, int request);
void send_error(Display* display, GlxError error, XID resource, int request);

}  // namespace gw::gl::glx
