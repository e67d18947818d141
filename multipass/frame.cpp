// Steps in order; shadow steps by the kind of their light's shadow.
#include "multipass/frame.h"

#include "multipass/shadow_passes.h"

#include <algorithm>

namespace gw::multipass {
namespace {

void add_shadow(CommandList& list, const Frame& frame, const Step& step) {
    const std::string name = name_of(step, *frame.stage.model);
    const std::size_t light = *step.light;
    if (frame.stage.model->scene->lights[light].shadow == scene::Shadow::Map)
        add_shadow_mask(list, frame.stage, name, frame.shadows.masks[light]);
    else
        add_shadow_volumes(list, frame.stage, name, frame.shadows.volumes[light],
                           {frame.rules.stencil_bits, frame.rules.one_winner, frame.shadows.one_by_one});
}

}  // namespace

CommandList commands(const Frame& frame, std::size_t first, std::size_t last) {
    CommandList list;
    for (std::size_t i = first; i < last; ++i) {
        const Step& step = frame.steps[i];
        if (step.pass.action == PassAction::Shadow)
            add_shadow(list, frame, step);
        else
            add_step(list, frame.stage, step, frame.rules);
    }
    return list;
}

std::size_t end_of_depth(const std::vector<Step>& steps) {
    const auto last = std::find_if(steps.rbegin(), steps.rend(),
                                   [](const Step& s) { return s.pass.depth.test && s.pass.depth.mask; });
    return static_cast<std::size_t>(steps.rend() - last);
}

}  // namespace gw::multipass
