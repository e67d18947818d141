// The renderer under test: a lit pyramid in two passes [K3.3]. Depth and ambient light first, then
// diffuse light added where the same faces are visible.
#pragma once

#include <gw/command_list.h>

namespace my_renderer {

/// For a window as wide as it is high. `turn`: degrees about the vertical axis, a multiple of 90.
gw::CommandList pyramid(int turn = 0);

}  // namespace my_renderer
