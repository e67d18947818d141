// Drawings of pieces and of lines as SVG. Does not cut pieces or hide lines.
#pragma once

#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

/// The pieces' outlines in the window, numbered in the order drawn. `colors`: "#rrggbb" of each
/// polygon by index. SVG 1.1, y down, one unit a pixel.
std::string pieces_svg(const Input& input, const std::vector<Piece>& pieces,
                       const std::vector<std::string>& colors);

/// A line drawing: visible parts in full lines, hidden parts in thin broken ones. SVG 1.1, y down, one
/// unit a pixel.
std::string lines_svg(const Input& input, const std::vector<Line>& lines);

}  // namespace gw::hiddensurface
