// Pictures from frames.
#include "multipass/driver.h"

#include "multipass/picture.h"
#include "multipass/scene_maps.h"

#include <algorithm>

namespace gw::multipass {
namespace {

Superposition draw(Machine& machine, const scene::Scene& scene, const scene::View& view,
                   const PassList& passes, const Options& options, const vec3& background) {
    check_lights(scene, passes, machine.profile());
    Picture picture(machine, scene, view, passes, options, background);
    return superpose(machine, std::max(options.samples, samples_of(scene)), picture.images(),
                     [&](const Sample& sample) { picture.draw(sample); });
}

}  // namespace

PassList pass_list(const scene::Scene& scene, const Options& options) {
    return options.passes ? *options.passes : passes_for(scene, options.renderer, options.translucency);
}

Superposition render(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     const Options& options) {
    return draw(machine, with_scene_maps(machine, scene, view, options), view, pass_list(scene, options),
                options, scene.background);
}

CommandList frame_list(const scene::Scene& scene, const scene::View& view, const PassList& passes,
                       const vec3& background, bool one_winner, int stencil_bits) {
    const Model model = make_model(scene);
    const Shadows shadows = find_volumes(model, topologies(model));
    const Stage stage = make_stage(model, enclosing(view, model, shadows));
    const Frame frame{stage, shadows, schedule(passes, model), {background, one_winner, stencil_bits}};
    return commands(frame, 0, frame.steps.size());
}

std::vector<ComponentImage> render_components(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, const Options& options) {
    std::vector<ComponentImage> images;
    const scene::Scene ready = with_scene_maps(machine, scene, view, options);
    for (const ComponentList& component : component_lists(scene, pass_list(scene, options))) {
        draw(machine, ready, view, component.passes, options,
             component.background ? scene.background : vec3(0));
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
