#include "multipass/shadow/shadows.h"

#include "multipass/shadow/shadow_lookup.h"
#include "scene/draw/item_buffer.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace gw::multipass {

std::vector<TopologyRef> topologies(const PassModel& model) {
    const auto& lights = model.scene->lights;
    const auto casts = [](const scene::Light& light) {
        return light.shadow == scene::Shadow::Volume;
    };
    if (std::none_of(lights.begin(), lights.end(), casts)) return {};
    std::vector<TopologyRef> result;
    std::unordered_map<const Mesh*, TopologyRef> of_mesh;
    for (const Part& part : model.parts) {
        TopologyRef& shared = of_mesh[part.mesh.get()];
        if (!shared) shared = std::make_shared<const Topology>(topology(*part.mesh));
        result.push_back(shared);
    }
    return result;
}

Shadows find_volumes(const PassModel& model, const std::vector<TopologyRef>& topologies) {
    const auto& lights = model.scene->lights;
    Shadows shadows;
    shadows.volumes.resize(lights.size());
    shadows.maps.resize(lights.size());
    shadows.masks.resize(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].shadow == scene::Shadow::Volume)
            shadows.volumes[i] = shadow_volumes(model, topologies, i);
    return shadows;
}

void find_masks(Shadows& shadows, Machine& machine, const PassModel& model, const scene::View& view,
                const JitterState& jitter) {
    const auto& lights = model.scene->lights;
    std::vector<std::uint32_t> ids;
    std::optional<scene::WorldTriangles> polygons;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (lights[i].shadow != scene::Shadow::Map) continue;
        const int size = shadow_map_size(view.width, view.height);
        if (shadows.maps[i].empty())
            shadows.maps[i] =
                draw_shadow_maps(machine, model, light_views(lights[i], *model.scene, size),
                                 view.width, view.height);
        if (ids.empty()) ids = scene::draw_item_buffer(machine, *model.scene, view, jitter);
        if (!polygons) polygons.emplace(*model.scene);
        shadows.masks[i] = shadow_mask(*polygons, lights[i], shadows.maps[i], ids, view, jitter,
                                       machine.profile());
    }
}

scene::View enclosing(scene::View view, const PassModel& model, const Shadows& shadows) {
    for (const auto& volumes : shadows.volumes) view = enclosing(view, model, volumes);
    return view;
}

}  // namespace gw::multipass
