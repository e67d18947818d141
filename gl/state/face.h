// The faces that calls name.
#pragma once

#include <GL/gl.h>

namespace gw::gl {

constexpr bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

}  // namespace gw::gl
