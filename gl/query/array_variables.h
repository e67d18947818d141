// The state variables of vertex arrays. [GL11] table 6.6
#pragma once

#include "gl/query/limits.h"

namespace gw::gl {

void add_arrays(StateVariables& t);

}  // namespace gw::gl
