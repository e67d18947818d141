// Which polygons lie over each pixel, whatever is seen. Does not compare depths.
#pragma once

#include "hiddensurface/run/algorithm.h"

namespace gw::hiddensurface {

/// Identifiers in the order of the scene, for each pixel of the window, bottom row first.
std::vector<std::vector<std::uint32_t>> polygons_over(const Input& input);

}  // namespace gw::hiddensurface
