// A program in the browser is one module: no other library could have a context. Compiled by
// Emscripten alone.
#include "gl/context/current.h"

namespace gw::gl {

Context* context_of_other_library() { return nullptr; }

}  // namespace gw::gl
