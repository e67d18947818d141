// The parts of the table of state variables, each in a file of its own.
#pragma once

#include "gl/query/values.h"

#include <map>

namespace gw::gl {

using Getter = QueryValues (*)(Context&);
using StateVariables = std::map<GLenum, Getter>;

/// Limits of this implementation. [GL11] tables 6.20 to 6.22
void add_limits(StateVariables& variables);
/// The active texture unit. [GL13] tables 6.6, 6.16 and 6.17
void add_texture_units(StateVariables& variables);
/// Vertex arrays. [GL11] table 6.6
void add_arrays(StateVariables& variables);

}  // namespace gw::gl
