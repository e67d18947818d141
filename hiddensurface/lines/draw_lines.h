// Draws lines on a machine, and compares them with the Z-buffer's hidden-line picture. Does not hide
// lines.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

/// The visible parts, white on black, one pass of lines; no depth test.
CommandList draw_lines(const Input& input, const std::string& name, const std::vector<Line>& lines);

struct LineResult {
    LineCounts counts;
    std::vector<Line> lines;
    std::vector<bool> lit,
        z_buffer;  ///< pixels, bottom row first: of this picture, of the Z-buffer's
};
/// Runs the algorithm, draws its lines on a machine of the view's size, and compares the pixels
/// with those of the Z-buffer's hidden-line picture: `missing` and `extra` in the counts. That
/// picture shifts faces slightly behind their own sides (styles.h), so it is not exact to the pixel.
LineResult run_on(Machine& machine, const LineAlgorithm& algorithm, const Input& input,
                  StepLog& log);

}  // namespace gw::hiddensurface
