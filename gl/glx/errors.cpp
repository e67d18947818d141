#include "gl/glx/errors.h"

#include "gl/glx/displays.h"

// Xlib's interface for extensions. It defines macros, so it comes last.
#include <X11/Xlibint.h>

namespace gw::gl::glx {

namespace {

/// Behind the numbers of the extensions that servers have.
constexpr ExtensionCodes without_extension{.request = 255, .event_base = 110, .error_base = 220};

void raise(Display* display, int code, XID resource, int request) {
    xError error{};
    error.type = X_Error;
    error.errorCode = BYTE(code);
    error.sequenceNumber = CARD16(XNextRequest(display) - 1);
    error.resourceID = CARD32(resource);
    error.minorCode = CARD16(request);
    error.majorCode = CARD8(codes_of(display).request);
    LockDisplay(display);
    _XError(display, &error);
    UnlockDisplay(display);
}

}  // namespace

ExtensionCodes query_codes(Display* display) {
    ExtensionCodes codes;
    const bool has =
        XQueryExtension(display, "GLX", &codes.request, &codes.event_base, &codes.error_base) != 0;
    return has ? codes : without_extension;
}

void send_error(Display* display, int core_error, XID resource, int request) {
    raise(display, core_error, resource, request);
}

void send_error(Display* display, GlxError error, XID resource, int request) {
    raise(display, codes_of(display).error_base + int(error), resource, request);
}

}  // namespace gw::gl::glx
