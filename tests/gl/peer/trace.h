// A library whose calls are printed before they are carried out.
#pragma once

#include "tests/gl/peer/library.h"

namespace gw::gl_peer {

/// Only one at a time.
Gl traced(const Gl& gl);

}  // namespace gw::gl_peer
