// Lists from the catalogue.
#include "multipass/passes.h"

#include "gw/error.h"
#include "multipass/catalogue.h"
#include "multipass/one_winner.h"
#include "scene/draw_commands.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::multipass {
namespace {

Pass depth_pass_for(const scene::Scene& scene) {
    Pass pass = depth_pass;
    pass.color = scene.background != vec3(0);
    return pass;
}

std::size_t lights_on(const scene::Scene& scene, const scene::Object& object) {
    return static_cast<std::size_t>(
        std::count_if(scene.lights.begin(), scene.lights.end(),
                      [&](const scene::Light& light) { return scene::lights_object(light, object); }));
}

}  // namespace

PassList passes_for(const scene::Scene& scene, Renderer renderer) {
    if (renderer == Renderer::Hardware) return {hardware_pass};
    return {depth_pass_for(scene), shadow_pass,     ambient_pass,    diffuse_pass,
            specular_pass,         reflection_pass, refraction_pass, emission_pass};
}

std::vector<ComponentList> component_lists(const scene::Scene& scene, const PassList& passes) {
    PassList common;
    std::copy_if(passes.begin(), passes.end(), std::back_inserter(common),
                 [](const Pass& p) { return !is_additive(p); });
    std::vector<ComponentList> lists;
    if (scene.background != vec3(0)) lists.push_back({"background", common, true});
    for (const Pass& pass : passes) {
        if (!is_additive(pass)) continue;
        ComponentList component{.name = pass.name.str()};
        std::copy_if(passes.begin(), passes.end(), std::back_inserter(component.passes),
                     [&](const Pass& p) { return !is_additive(p) || p.name == pass.name; });
        lists.push_back(std::move(component));
    }
    return lists;
}

void check_lights(const scene::Scene& scene, const PassList& passes, const Profile& profile) {
    const bool all =
        std::any_of(passes.begin(), passes.end(), [](const Pass& p) { return p.lights == PassLights::All; });
    if (!all) return;
    for (const scene::Object& item : scene.objects)
        if (lights_on(scene, item) > static_cast<std::size_t>(profile.max_lights))
            throw Error(
                fmt::format("{} lights on object '{}'; profile {} knows {} in one pass. "
                            "--renderer multipass has no limit",
                            lights_on(scene, item), item.name, profile.name, profile.max_lights));
}

}  // namespace gw::multipass
