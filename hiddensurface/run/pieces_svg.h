// The pieces of an algorithm as a drawing: outlines in the window, numbered in the order drawn.
// Does not cut.
#pragma once

#include "hiddensurface/run/algorithm.h"

namespace gw::hiddensurface {

/// `colors`: "#rrggbb" of each polygon by index. SVG 1.1, y down, one unit a pixel.
std::string pieces_svg(const Input& input, const std::vector<Piece>& pieces,
                       const std::vector<std::string>& colors);

}  // namespace gw::hiddensurface
