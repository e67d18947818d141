#include "itembuffer/hit_shadows.h"

#include "multipass/frame/pass_model.h"

namespace gw::itembuffer {

int HitShadows::size(int width, int height) {
    return multipass::shadow_map_size(width, height) / 2;
}

HitShadows::HitShadows(Machine& machine, const scene::Scene& scene, int width, int height) {
    const multipass::PassModel model = multipass::make_pass_model(scene);
    for (const scene::Light& light : scene.lights) {
        maps_.emplace_back();
        if (light.shadow == scene::Shadow::None) continue;
        const auto views = multipass::light_views(light, scene::bounds(scene), size(width, height));
        maps_.back() = multipass::draw_shadow_maps(machine, model, views, width, height);
    }
    for (const auto& maps : maps_) lookups_.emplace_back(maps, machine.profile());
}

}  // namespace gw::itembuffer
