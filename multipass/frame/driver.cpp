#include "multipass/frame/driver.h"

#include "multipass/frame/frame_drawer.h"
#include "multipass/frame/scene_maps.h"
#include "multipass/frame/superpose.h"

#include <algorithm>
#include <optional>

namespace gw::multipass {

/// The scene with its maps, if some are generated from it, and the drawer of its frames.
struct Driver::PreparedScene {
    std::optional<scene::Scene> with_maps;
    FrameDrawer drawer;

    PreparedScene(Machine& machine, const scene::Scene& scene,
                  std::optional<scene::Scene> generated, const PassList& passes,
                  const Options& options)
        : with_maps(std::move(generated)),
          drawer(machine, with_maps ? *with_maps : scene, passes, options, scene.background) {}
};

Driver::Driver(Machine& machine, scene::Scene scene, const Options& options)
    : machine_(machine),
      scene_(std::move(scene)),
      options_(options),
      passes_(pass_list(scene_, options)) {
    check_lights(scene_, passes_, machine.profile());
    check_glare(scene_, passes_, most_pictures(machine.profile()));
}

Driver::~Driver() = default;

Superposition Driver::draw(const scene::View& view) {
    std::optional<scene::Scene> with_maps;
    if (has_scene_maps(scene_, options_))
        with_maps = with_scene_maps(machine_, scene_, view, options_);
    if (!prepared_ || with_maps)
        prepared_ = std::make_unique<PreparedScene>(machine_, scene_, std::move(with_maps), passes_,
                                                    options_);
    const int samples = std::max(options_.samples, samples_of(scene_));
    return superpose(
        machine_, samples, prepared_->drawer.images(),
        [&](const Sample& sample) { prepared_->drawer.draw(view, sample); },
        weights_of(samples, options_.weighted, machine_.profile()));
}

PassList pass_list(const scene::Scene& scene, const Options& options) {
    return options.pass_list ? *options.pass_list
                             : passes_for(scene, options.renderer, options.translucency);
}

Superposition render(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     const Options& options) {
    return Driver(machine, scene, options).draw(view);
}

CommandList frame_list(const scene::Scene& scene, const scene::View& view, const PassList& passes,
                       const vec3& background, bool one_winner, int stencil_bits) {
    const PassModel model = make_pass_model(scene);
    const Shadows shadows = find_volumes(model, topologies(model));
    const PlacedModel placed = place_model(model, enclosing(view, model, shadows));
    const Frame frame{
        placed,
        shadows,
        schedule(passes, model),
        {.background = background, .one_winner = one_winner, .stencil_bits = stencil_bits}};
    CommandList list;
    add_steps(list, frame, 0, frame.steps.size());
    return list;
}

std::vector<ComponentImage> render_components(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, const Options& options) {
    scene::Scene with_maps = with_scene_maps(machine, scene, view, options);
    return component_images(component_lists(scene, pass_list(scene, options)),
                            [&](const ComponentList& list) {
                                Options of_component = options;
                                of_component.pass_list = list.passes;
                                with_maps.background = list.background ? scene.background : vec3(0);
                                render(machine, with_maps, view, of_component);
                                return machine.planes().color;
                            });
}

std::string print_passes(const PassList& passes) {
    std::string text;
    for (const Pass& pass : passes) text += to_string(pass) + "\n";
    return text;
}

}  // namespace gw::multipass
