#include "gl/x11/extension.h"

// Xlib's interface for extensions. It defines macros, so it comes last.
#include <X11/Xlibint.h>

namespace gw::gl::x11 {

void call_at_close(Display* display, CloseHook hook) {
    if (const XExtCodes* const codes = XAddExtension(display))
        XESetCloseDisplay(display, codes->extension, hook);
}

XID new_name(Display* dpy) {  // SyncHandle() expands to a use of `dpy`
    // Xlib has one name ready at a time. It readies the next one in LockDisplay and SyncHandle.
    LockDisplay(dpy);
    const XID name = XAllocID(dpy);
    UnlockDisplay(dpy);
    SyncHandle();
    return name;
}

}  // namespace gw::gl::x11
