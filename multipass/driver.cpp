// A frame: the passes that clear and find Z, the count of winners, then all others.
#include "multipass/driver.h"

#include "multipass/commands.h"
#include "multipass/one_winner.h"
#include "multipass/schedule.h"
#include "multipass/stage.h"

#include <algorithm>

namespace gw::multipass {
namespace {

/// One frame of one view.
struct Frame {
    const Stage& stage;
    std::vector<Step> steps;
    FrameRules rules;
};

CommandList commands(const Frame& frame, std::size_t first, std::size_t last) {
    CommandList list;
    for (std::size_t i = first; i < last; ++i) add_step(list, frame.stage, frame.steps[i], frame.rules);
    return list;
}

/// Steps up to and with the last that updates Z.
std::size_t end_of_depth(const std::vector<Step>& steps) {
    const auto last = std::find_if(steps.rbegin(), steps.rend(),
                                   [](const Step& s) { return s.pass.depth.test && s.pass.depth.mask; });
    return static_cast<std::size_t>(steps.rend() - last);
}

bool any_opaque(const Model& model) {
    return std::any_of(model.parts.begin(), model.parts.end(), [](const Part& p) { return !p.translucent; });
}

bool wants_count(const Frame& frame, OneWinner choice) {
    return choice == OneWinner::Auto && any_opaque(*frame.stage.model) &&
           std::any_of(frame.steps.begin(), frame.steps.end(),
                       [](const Step& s) { return is_additive(s.pass); });
}

bool has_coincident_faces(Machine& machine, const Stage& stage) {
    machine.execute(count_winners(stage));
    const auto& passes = machine.passes();
    return surplus_winners(std::span(passes).last(2)) > 0;
}

void run(Machine& machine, Frame& frame, OneWinner choice) {
    frame.rules.one_winner = choice == OneWinner::Always;
    frame.rules.stencil_bits = machine.profile().stencil_bits;
    std::size_t next = 0;
    if (wants_count(frame, choice)) {
        next = end_of_depth(frame.steps);
        machine.execute(commands(frame, 0, next));
        frame.rules.one_winner = has_coincident_faces(machine, frame.stage);
    }
    machine.execute(commands(frame, next, frame.steps.size()));
}

PassList passes_of(const scene::Scene& scene, const Options& options) {
    return options.passes ? *options.passes : passes_for(scene, options.renderer);
}

}  // namespace

CommandList frame_list(const scene::Scene& scene, const scene::View& view, const PassList& passes,
                       const vec3& background, bool one_winner, int stencil_bits) {
    const Model model = make_model(scene);
    const Stage stage = make_stage(model, view);
    const Frame frame{stage, schedule(passes, model), {background, one_winner, stencil_bits}};
    return commands(frame, 0, frame.steps.size());
}

void render(Machine& machine, const scene::Scene& scene, const scene::View& view, const Options& options) {
    const PassList passes = passes_of(scene, options);
    check_lights(scene, passes, machine.profile());
    const Model model = make_model(scene);
    const Stage stage = make_stage(model, view);
    Frame frame{stage, schedule(passes, model), {.background = scene.background}};
    run(machine, frame, options.one_winner);
}

std::vector<ComponentImage> render_components(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, const Options& options) {
    const Model model = make_model(scene);
    const Stage stage = make_stage(model, view);
    std::vector<ComponentImage> images;
    for (const ComponentList& component : component_lists(scene, passes_of(scene, options))) {
        Frame frame{stage, schedule(component.passes, model), {}};
        if (component.background) frame.rules.background = scene.background;
        run(machine, frame, options.one_winner);
        images.push_back({component.name, machine.planes().color});
    }
    return images;
}

std::string print_passes(const PassList& passes) {
    std::string text;
    for (const Pass& pass : passes) text += to_string(pass) + "\n";
    return text;
}

}  // namespace gw::multipass
