#include "gl/x11/close_hook.h"

// Xlib's interface for extensions. It defines macros, so it comes last.
#include <X11/Xlibint.h>

namespace gw::gl::x11 {

void call_at_close(Display* display, CloseHook hook) {
    if (const XExtCodes* const codes = XAddExtension(display))
        XESetCloseDisplay(display, codes->extension, hook);
}

}  // namespace gw::gl::x11
