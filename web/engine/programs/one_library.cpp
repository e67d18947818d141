// A program in the browser is one module: there is no other library that could have a context.
#include "gl/context/current.h"

namespace gw::gl {

Context* context_of_other_library() { return nullptr; }

}  // namespace gw::gl
