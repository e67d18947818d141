#include "gl/x11/new_name.h"

// Xlib's interface for extensions. It defines macros, so it comes last.
#include <X11/Xlibint.h>

namespace gw::gl::x11 {

XID new_name(Display* dpy) {  // SyncHandle() expands to a use of `dpy`
    // Xlib has one name ready at a time. It readies the next one in LockDisplay and SyncHandle.
    LockDisplay(dpy);
    const XID name = XAllocID(dpy);
    UnlockDisplay(dpy);
    SyncHandle();
    return name;
}

}  // namespace gw::gl::x11
