// A frame: the passes that clear and find Z, the count of winners, then all others.
#include "multipass/driver.h"

#include "gw/error.h"
#include "multipass/frame.h"
#include "multipass/one_winner.h"
#include "multipass/shadow_passes.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::multipass {
namespace {

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

/// Executes a frame. False: a shadow count may have overflowed.
bool execute(Machine& machine, Frame& frame, OneWinner choice) {
    const std::size_t before = machine.passes().size();
    frame.rules.one_winner = choice == OneWinner::Always;
    frame.rules.stencil_bits = machine.profile().stencil_bits;
    std::size_t next = 0;
    if (wants_count(frame, choice)) {
        next = end_of_depth(frame.steps);
        machine.execute(commands(frame, 0, next));
        frame.rules.one_winner = has_coincident_faces(machine, frame.stage);
    }
    machine.execute(commands(frame, next, frame.steps.size()));
    return !any_overflow(std::span(machine.passes()).subspan(before));
}

/// What does not change from frame to frame.
struct Prepared {
    Model model;
    Shadows shadows;
    Stage stage;

    Prepared(const scene::Scene& scene, const scene::View& view)
        : model(make_model(scene)),
          shadows(find_volumes(model, topologies(model))),
          stage(make_stage(model, enclosing(view, model, shadows))) {
        cut_at(view.camera.far_plane);
    }

    /// What lies behind the picture's own far plane stays cut off where shadow volumes moved it.
    void cut_at(double far_plane) {
        const bool moved = far_plane < stage.view.camera.far_plane;
        const double farthest =
            scene::depth_interval(scene::bounds(*model.scene), stage.view.eye_from_world).farthest;
        if (moved && farthest > far_plane) stage.state.clip_planes[0] = {true, dvec4(0, 0, 1, far_plane)};
    }
};

void draw_frame(Machine& machine, Prepared& prepared, const PassList& passes, const vec3& background,
                OneWinner choice) {
    const auto attempt = [&] {
        Frame frame{
            prepared.stage, prepared.shadows, schedule(passes, prepared.model), {.background = background}};
        return execute(machine, frame, choice);
    };
    find_masks(prepared.shadows, machine, prepared.model, prepared.stage.view, prepared.stage.state.jitter);
    prepared.shadows.one_by_one = false;
    if (attempt()) return;
    prepared.shadows.one_by_one = true;
    if (!attempt())
        throw Error(fmt::format(
            "an object's shadow volume is deeper than {} stencil bits count; use shadow = \"map\"",
            machine.profile().stencil_bits));
}

PassList passes_of(const scene::Scene& scene, const Options& options) {
    return options.passes ? *options.passes : passes_for(scene, options.renderer);
}

}  // namespace

CommandList frame_list(const scene::Scene& scene, const scene::View& view, const PassList& passes,
                       const vec3& background, bool one_winner, int stencil_bits) {
    const Prepared prepared(scene, view);
    const Frame frame{prepared.stage,
                      prepared.shadows,
                      schedule(passes, prepared.model),
                      {background, one_winner, stencil_bits}};
    return commands(frame, 0, frame.steps.size());
}

void render(Machine& machine, const scene::Scene& scene, const scene::View& view, const Options& options) {
    const PassList passes = passes_of(scene, options);
    check_lights(scene, passes, machine.profile());
    Prepared prepared(scene, view);
    draw_frame(machine, prepared, passes, scene.background, options.one_winner);
}

std::vector<ComponentImage> render_components(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, const Options& options) {
    Prepared prepared(scene, view);
    std::vector<ComponentImage> images;
    for (const ComponentList& component : component_lists(scene, passes_of(scene, options))) {
        draw_frame(machine, prepared, component.passes, component.background ? scene.background : vec3(0),
                   options.one_winner);
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
