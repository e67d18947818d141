// An implementation of OpenGL in a shared library, loaded when it is asked for, and a context on it.
#pragma once

#include "inspect/peer/loaded.h"

#include <memory>
#include <string>

namespace gw::peer {

/// A context with planes of 8 colour, 24 depth, 8 stencil and 16 accumulation bits.
class Surface {
public:
    virtual ~Surface() = default;
    /// gl() has its functions then.
    virtual void make_current() = 0;
};

/// `implementation`: "osmesa", Mesa's off-screen library; "gl", the libGL.so.1 that programs find,
/// through GLX on $DISPLAY; else the path of a libOSMesa or a libGL. Throws Error if it cannot be
/// loaded, is neither, or makes no such context.
std::unique_ptr<Surface> make_surface(const std::string& implementation, int width, int height);

/// The two kinds: memory of ours by OSMesa, a pbuffer by GLX.
std::unique_ptr<Surface> make_osmesa(const Loaded& loaded, int width, int height);
/// Throws Error if $DISPLAY has no X server or the server and the library have no GLX 1.3.
std::unique_ptr<Surface> make_glx(const Loaded& loaded, int width, int height);

}  // namespace gw::peer
