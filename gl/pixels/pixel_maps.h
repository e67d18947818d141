// The ten tables of pixel transfer. [GL11] 3.6.3
#pragma once

#include <GL/gl.h>

#include <array>
#include <vector>

namespace gw::gl {

inline constexpr int pixel_map_count = 10;
inline constexpr int max_pixel_map = 256;

struct PixelMaps {
    /// GL_PIXEL_MAP_I_TO_I .. GL_PIXEL_MAP_A_TO_A. Values of the maps to indices are integers.
    std::array<std::vector<float>, pixel_map_count> tables;
    PixelMaps() { tables.fill({0.0f}); }
    const std::vector<float>& operator[](GLenum map) const {
        return tables[map - GL_PIXEL_MAP_I_TO_I];
    }
};

}  // namespace gw::gl
