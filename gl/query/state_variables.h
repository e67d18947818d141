// Every state variable by its name.
#pragma once

#include "gl/query/values.h"

#include <optional>

namespace gw::gl {

struct Context;

/// The values of a state variable; none: there is no such variable.
std::optional<QueryValues> state_variable(Context& c, GLenum pname);

}  // namespace gw::gl
