// X errors: those that GLX's functions raise, and those of our own requests, which the program's
// error handler must not see.
#pragma once

#include "gl/glx/x11.h"

#include <memory>

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

/// The numbers of GLX on a display. If the server has no GLX, numbers that no other extension of
/// the server is likely to have.
struct ExtensionCodes {
    int request = 0, event_base = 0, error_base = 0;
};
ExtensionCodes query_codes(Display* display);

/// Gives the program's X error handler an error of the core (BadMatch) or of GLX, as if the server
/// had answered the GLX request of this number (X_GLXMakeCurrent).
void send_error(Display* display, int core_error, XID resource, int request);
void send_error(Display* display, GlxError error, XID resource, int request);

/// XLockDisplay .. XUnlockDisplay.
class LockedDisplay {
public:
    explicit LockedDisplay(Display* display) : display_(display) { XLockDisplay(display); }
    ~LockedDisplay() { XUnlockDisplay(display_); }
    LockedDisplay(const LockedDisplay&) = delete;
    LockedDisplay& operator=(const LockedDisplay&) = delete;

private:
    Display* const display_;
};

/// While it lives, the calling thread has the display for itself, and errors of its requests are
/// counted here, not reported.
class QuietErrors {
public:
    explicit QuietErrors(Display* display);
    ~QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;

    /// Waits for the server. Whether a request since the construction failed.
    bool failed();

private:
    struct Handler;
    Display* const display_;
    const LockedDisplay locked_;
    std::unique_ptr<Handler> handler_;
};

}  // namespace gw::gl::glx
