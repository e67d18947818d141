// A frame: one view of one scene at one moment, all of its passes as commands. Does not execute
// them (frame_drawer.h).
#pragma once

#include "gw/command_list.h"
#include "multipass/shadow/shadows.h"
#include "multipass/steps/commands.h"
#include "multipass/steps/placed_model.h"
#include "multipass/steps/schedule.h"

#include <vector>

namespace gw::multipass {

/// Refers to the placed model and the shadows, which must outlive it.
struct Frame {
    const PlacedModel& placed;
    const Shadows& shadows;
    std::vector<Step> steps;
    FrameRules rules;
    std::vector<Rgba> traced;  ///< the traced component by pixel; empty: nothing is traced [K4]
};

/// Adds the commands of steps first .. last - 1.
void add_steps(CommandList& list, const Frame& frame, std::size_t first, std::size_t last);

/// The number of steps up to and including the last that updates Z.
std::size_t end_of_depth(const std::vector<Step>& steps);

/// The number of images that the steps add in the accumulation buffer.
int images_of(const std::vector<Step>& steps);

/// Steps first .. last - 1 are drawn layer by layer (translucency.h); first = last: none is.
struct LayerSteps {
    std::size_t first = 0, last = 0;
};
LayerSteps layer_steps(const std::vector<Step>& steps);

}  // namespace gw::multipass
