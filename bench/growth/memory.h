// The memory of a long run: frames whose meshes and textures change all the time.
#pragma once

#include "gw/base/types.h"

#include <functional>
#include <vector>

namespace gw::growth {

/// Megabytes of the process by frame, a hundred samples. Calls `progress(frame)` at each.
std::vector<dvec2> memory_by_frame(int frames, const std::function<void(int)>& progress);

}  // namespace gw::growth
