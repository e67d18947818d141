#include "gl/glx/close_hook.h"

// Xlib's interface for extensions. It defines macros, so it comes last.
#include <X11/Xlibint.h>

namespace gw::gl::glx {

void call_at_close(Display* display, CloseHook hook) {
    if (const XExtCodes* const codes = XAddExtension(display))
        XESetCloseDisplay(display, codes->extension, hook);
}

}  // namespace gw::gl::glx
