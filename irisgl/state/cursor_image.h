// The image of a cursor. Plain data.
#pragma once

#include <cstdint>
#include <vector>

namespace gw::irisgl {

/// 16 or 32 pixels wide and high, bottom row first, each 0 (nothing) to 3.
struct CursorImage {
    int size = 16;
    bool is_cross = false;  ///< lines over the whole screen instead
    std::vector<std::uint8_t> pixels;
    short x = 0, y = 0;  ///< the pixel that points
};

}  // namespace gw::irisgl
