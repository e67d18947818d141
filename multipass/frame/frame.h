// A frame: one view of one scene at one moment, all of its passes as commands. Does not execute
// them: picture.h does.
#pragma once

#include "gw/command_list.h"
#include "multipass/frame/commands.h"
#include "multipass/frame/placed_model.h"
#include "multipass/passes/schedule.h"
#include "multipass/shadow/shadows.h"

#include <vector>

namespace gw::multipass {

/// Refers to the stage and the shadows, which must outlive it.
struct Frame {
    const Stage& stage;
    const Shadows& shadows;
    std::vector<Step> steps;
    FrameRules rules;
    std::vector<Rgba> traced;  ///< of the view's pixels; empty: nothing [K4]
};

/// The commands of steps first .. last - 1.
CommandList commands(const Frame& frame, std::size_t first, std::size_t last);

/// The number of steps up to and with the last that updates Z.
std::size_t end_of_depth(const std::vector<Step>& steps);

/// Images that the steps add in the accumulation buffer.
int images_of(const std::vector<Step>& steps);

/// Steps first .. last - 1 are those that are drawn layer by layer (layers.h); none: first = last.
struct LayerSteps {
    std::size_t first = 0, last = 0;
};
LayerSteps layer_steps(const std::vector<Step>& steps);

}  // namespace gw::multipass
