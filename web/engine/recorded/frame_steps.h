// A frame of a recorded program, step by step: a few polygons or lines each, in the order in which the
// program drew them. The steps are passes of another recording with the same bits.
#pragma once

#include "inspect/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gw::lab {

struct FrameStep {
    enum class Kind : std::uint8_t { Clear, Primitives, Pixels, Shown, Other };
    Kind kind = Kind::Other;
    std::size_t polygons = 0, lines = 0, points = 0;
};

struct FrameSteps {
    /// Its pass 0 is everything before the frame, its pass i + 1 the step i.
    inspect::Recording recording;
    std::vector<FrameStep> steps;
    /// Whether the frame is drawn in the back plane.
    bool is_back = false;
    bool uses_depth = false;  ///< tests or clears depths
};

/// Of the pass `pass`. As many primitives a step that they make at most `most` steps, beside those of
/// other commands; a mesh whose primitives share corners, such as a strip, is drawn in one.
FrameSteps steps_of(const inspect::Recording& recording, std::size_t pass, std::size_t most);

}  // namespace gw::lab
