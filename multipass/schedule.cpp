// Repetition of passes, and who takes part in each.
#include "multipass/schedule.h"

#include "scene/draw_commands.h"

#include <algorithm>

namespace gw::multipass {
namespace {

bool is_black(const Material& m) {
    return m.Ka == vec3(0) && m.Kd == vec3(0) && m.Ks == vec3(0) && m.Ke == vec3(0);
}

/// The same under a light: what it does not send is not reflected.
Material lit(Material m, const scene::Light& light) {
    m.Ka *= light.Ia;
    m.Kd *= light.Id;
    m.Ks *= light.Is.value_or(light.Id);
    return m;
}

/// A set of values only, all of them 0: the pass is there for Z or fog.
bool is_black(const PassMaterial& set) {
    const Parameter none;
    return set.Ka == none && set.Kd == none && set.Ks == none && set.Ke == none;
}

bool selected(const Pass& pass, const Part& part) {
    switch (pass.objects) {
        case PassObjects::All: return true;
        case PassObjects::Opaque: return !part.translucent;
        case PassObjects::Translucent: return part.translucent;
        case PassObjects::Named: break;
    }
    return std::find(pass.names.begin(), pass.names.end(), part.object->name) != pass.names.end();
}

/// Without a map of the component: the first run draws it as if the map was white, where that makes sense.
bool has_map(const Step& step, const Part& part) {
    const PassMap map = step.pass.material.Map;
    const bool by_map_only = map == PassMap::Reflection || map == PassMap::Refraction;
    const std::size_t count = part.maps_for(map).size();
    return step.map < count || (step.map == 0 && !by_map_only);
}

void add_runs(std::vector<Step>& steps, const Pass& pass, std::optional<std::size_t> light,
              const Model& model) {
    const bool casts = light && model.scene->lights[*light].shadow != scene::Shadow::None;
    if (pass.action == PassAction::Shadow && !casts) return;
    Step step{.pass = pass, .light = light};
    if (light && !casts && pass.stencil.test) step.pass.stencil = {};
    for (step.map = 0; step.map < repetitions(model, pass.material.Map); ++step.map) steps.push_back(step);
}

}  // namespace

std::vector<Step> schedule(const PassList& passes, const Model& model) {
    std::vector<Step> steps;
    for (auto pass = passes.begin(); pass != passes.end();) {
        if (pass->lights != PassLights::Each) {
            add_runs(steps, *pass++, std::nullopt, model);
            continue;
        }
        const auto last =
            std::find_if(pass, passes.end(), [](const Pass& p) { return p.lights != PassLights::Each; });
        for (std::size_t light = 0; light < model.scene->lights.size(); ++light)
            std::for_each(pass, last, [&](const Pass& p) { add_runs(steps, p, light, model); });
        pass = last;
    }
    return steps;
}

std::string name_of(const Step& step, const Model& model) {
    std::string name = step.pass.name.str();
    if (step.light) {
        const std::string& light = model.scene->lights[*step.light].name;
        name += " " + (light.empty() ? "light " + std::to_string(*step.light + 1) : light);
    }
    if (step.map > 0) name += " map " + std::to_string(step.map + 1);
    return name;
}

bool concerns(const Step& step, const Part& part, const Model& model) {
    if (!selected(step.pass, part)) return false;
    if (is_black(step.pass.material)) return true;
    const Material material = material_for(step.pass.material, *part.material);
    if (!has_map(step, part)) return false;
    if (!step.light) return !is_black(material);
    const scene::Light& light = model.scene->lights[*step.light];
    return scene::lights_object(light, *part.object) && !is_black(lit(material, light));
}

}  // namespace gw::multipass
