// Rectangles of pixels that are larger than a command of the machine, as pieces. [GL11] 3.6.4 has no
// largest rectangle.
#pragma once

#include "gw/command_list.h"

#include <functional>

namespace gw::gl {

/// Calls `take` for the parts of a rectangle of values or bits, of any size, in rows upwards.
/// Together they cover the same pixels of the window as the whole (R13.10).
void for_each_piece(gw::DrawPixels whole, const std::function<void(gw::DrawPixels)>& take);

}  // namespace gw::gl
