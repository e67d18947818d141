// GetString: the names of this implementation, by the profile.
#pragma once

#include "gw/profile.h"

#include <GL/gl.h>

namespace gw::gl {

/// Null: no such string. Lives as long as the program.
const char* implementation_string(const Profile& profile, GLenum name);

}  // namespace gw::gl
