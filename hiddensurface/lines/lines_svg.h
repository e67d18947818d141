// A line drawing as SVG: what is visible in full lines, what is hidden in thin broken ones. Does
// not hide lines.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

/// SVG 1.1, y down, one unit a pixel.
std::string lines_svg(const Input& input, const std::vector<Line>& lines);

}  // namespace gw::hiddensurface
