#include "gl/glx/errors.h"

#include "gl/glx/displays.h"

#include <cstdio>
#include <cstring>
#include <iterator>

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

/// [GLX 1.4] 3.5, and GLX_ARB_create_context_profile: GLX's errors in the order of their numbers.
constexpr const char* error_names[] = {
    "GLXBadContext",       "GLXBadContextState", "GLXBadDrawable",
    "GLXBadPixmap",        "GLXBadContextTag",   "GLXBadCurrentWindow",
    "GLXBadRenderRequest", "GLXBadLargeRequest", "GLXUnsupportedPrivateRequest",
    "GLXBadFBConfig",      "GLXBadPbuffer",      "GLXBadCurrentDrawable",
    "GLXBadWindow",        "GLXBadProfileARB"};

/// For XGetErrorText, which leaves the text empty for another extension's codes.
char* error_text(Display*, int code, XExtCodes* codes, char* text, int size) {
    const int number = code - codes->first_error;
    if (number >= 0 && number < int(std::size(error_names)))
        std::snprintf(text, std::size_t(size), "%s", error_names[number]);
    return text;
}

/// Has Xlib tell of errors and requests by GLX's names.
void name_extension(Display* display, const ExtensionCodes& codes) {
    XExtCodes* const own = XAddExtension(display);
    if (own == nullptr) return;
    LockDisplay(display);
    for (_XExtension* at = display->ext_procs; at != nullptr; at = at->next) {
        if (&at->codes != own) continue;
        own->major_opcode = codes.request;
        own->first_event = codes.event_base;
        own->first_error = codes.error_base;
        at->name = strdup("GLX");  // Xlib frees it
        at->error_string = &error_text;
    }
    UnlockDisplay(display);
}

}  // namespace

ExtensionCodes register_codes(Display* display) {
    ExtensionCodes codes;
    if (!XQueryExtension(display, "GLX", &codes.request, &codes.event_base, &codes.error_base))
        codes = without_extension;
    name_extension(display, codes);
    return codes;
}

void send_error(Display* display, int core_error, XID resource, int request) {
    raise(display, core_error, resource, request);
}

void send_error(Display* display, GlxError error, XID resource, int request) {
    raise(display, codes_of(display).error_base + int(error), resource, request);
}

}  // namespace gw::gl::glx
