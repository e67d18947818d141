// The limits of this implementation, as state variables. [GL11] tables 6.20 to 6.22
#pragma once

#include "gl/query/values.h"

#include <map>

namespace gw::gl {

using Getter = QueryValues (*)(Context&);
using StateVariables = std::map<GLenum, Getter>;

void add_limits(StateVariables& variables);

}  // namespace gw::gl
