#include "itembuffer/hit_shadows.h"

#include "multipass/model.h"

#include <memory>
#include <vector>

namespace gw::itembuffer {
namespace {

/// By light; no lookup for a light without shadow.
struct Maps {
    std::vector<std::vector<multipass::ShadowMap>> maps;
    std::vector<multipass::ShadowLookup> lookups;
};

}  // namespace

std::function<bool(std::size_t, const scene::TrianglePoint&)> hit_shadows(Machine& machine,
                                                                          const scene::Scene& scene,
                                                                          int width, int height) {
    const auto all = std::make_shared<Maps>();
    const multipass::Model model = multipass::make_model(scene);
    const int size = multipass::shadow_map_size(width, height);
    for (const scene::Light& light : scene.lights) {
        all->maps.emplace_back();
        if (light.shadow == scene::Shadow::None) continue;
        const auto views = multipass::light_views(light, scene::bounds(scene), size);
        all->maps.back() = multipass::draw_shadow_maps(machine, model, views, width, height);
    }
    for (const auto& maps : all->maps) all->lookups.emplace_back(maps, machine.profile());
    return [all](std::size_t light, const scene::TrianglePoint& at) {
        return all->lookups[light].in_shadow(at);
    };
}

}  // namespace gw::itembuffer
