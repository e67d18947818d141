// Where a process has one library of OpenGL of ours, no other could have a context: in the browser,
// where a program is one module, and on Windows. Compiled there alone.
#include "gl/context/current.h"

namespace gw::gl {

Context* context_of_other_library() { return nullptr; }

}  // namespace gw::gl
