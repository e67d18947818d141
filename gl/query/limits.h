// The limits of this implementation, as state variables. [GL11] tables 6.20 to 6.22. Those of the
// active texture unit. [GL13] tables 6.6, 6.16 and 6.17
#pragma once

#include "gl/query/values.h"

#include <map>

namespace gw::gl {

using Getter = QueryValues (*)(Context&);
using StateVariables = std::map<GLenum, Getter>;

void add_limits(StateVariables& variables);
void add_texture_units(StateVariables& variables);

}  // namespace gw::gl
