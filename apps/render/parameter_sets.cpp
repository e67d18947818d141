#include "apps/render/parameter_sets.h"

#include "multipass/passes/schedule.h"

namespace gw::apps {

std::map<std::string, std::string> parameter_sets(const Drawing& drawing) {
    std::map<std::string, std::string> sets;
    if (!drawing.renderer.passes) return sets;
    const multipass::PassModel model = multipass::make_pass_model(drawing.scene);
    for (const multipass::Step& step : multipass::schedule(passes_of(drawing), model))
        sets[multipass::name_of(step, model)] = multipass::to_string(step.pass.material);
    return sets;
}

}  // namespace gw::apps
