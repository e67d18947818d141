// Types of the components of vertex arrays. [GL11] table 2.4
#pragma once

#include "gl/pixels/formats.h"
#include "gl/pixels/packed.h"

namespace gw::gl {

/// The bytes of a component; 0: no type of an array.
inline std::size_t array_component_bytes(GLenum type) {
    if (packed_type(type) != nullptr) return 0;
    return type == GL_DOUBLE ? 8 : component_bytes(type);
}

}  // namespace gw::gl
