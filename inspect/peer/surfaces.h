// The two kinds of surfaces: memory of ours by OSMesa, a pbuffer by GLX.
#pragma once

#include "inspect/peer/library.h"
#include "inspect/peer/loaded.h"

namespace gw::peer {

std::unique_ptr<Surface> make_osmesa(const Loaded& loaded, int width, int height);

/// Throws Error if $DISPLAY has no X server or the server and the library have no GLX 1.3.
std::unique_ptr<Surface> make_glx(const Loaded& loaded, int width, int height);

}  // namespace gw::peer
