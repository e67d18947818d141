// The layout of pixels in the caller's memory. [GL11] 3.6.1
#pragma once

#include <GL/gl.h>

namespace gw::gl {

struct PixelStore {
    bool swap_bytes = false, lsb_first = false;
    GLint row_length = 0;  ///< pixels; 0: the width
    GLint skip_rows = 0, skip_pixels = 0;
    GLint alignment = 4;  ///< of rows: 1, 2, 4, 8 bytes
};

}  // namespace gw::gl
