#include "gl/context/current.h"

namespace gw::gl {

constinit thread_local Context* current = nullptr;

}  // namespace gw::gl
