#include "multipass/steps/schedule.h"

#include "multipass/passes/catalogue.h"
#include "scene/draw/draw_commands.h"

#include <algorithm>

namespace gw::multipass {
namespace {

bool is_black(const Material& m) {
    return m.Ka == vec3(0) && m.Kd == vec3(0) && m.Ks == vec3(0) && m.Ke == vec3(0);
}

/// The same under a light: only the colours that it sends are reflected.
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
        case PassObjects::Glaring: return part.object->glare.has_value();
        case PassObjects::Casting: return !part.translucent && part.object->casts_shadow;
        case PassObjects::Named: break;
    }
    return std::binary_search(pass.names.begin(), pass.names.end(), part.object->name);
}

/// Without a map of the component: the first run draws it as if the map was white, if the pass
/// allows it.
bool has_map(const Step& step, const Part& part) {
    const PassMap map = step.pass.material.Map;
    const bool by_map_only = map == PassMap::Reflection || map == PassMap::Refraction;
    const std::size_t count = part.maps_for(map).size();
    return step.map < count || (step.map == 0 && !by_map_only);
}

void add_runs(std::vector<Step>& steps, const Pass& pass, std::optional<std::size_t> light,
              const PassModel& model) {
    const bool casts = light && model.scene->lights[*light].shadow != scene::Shadow::None;
    if (pass.action == PassAction::Shadow && !casts) return;
    Step step{.pass = pass, .light = light};
    if (light && !casts && pass.stencil == outside_shadow) step.pass.stencil = {};
    std::sort(step.pass.names.begin(), step.pass.names.end());
    const std::size_t count = repetitions(model, pass.material.Map);
    for (step.map = 0; step.map < count; ++step.map) steps.push_back(step);
}

/// Of a pass that runs once: its light, if it has one; none: it does not run at all.
std::optional<std::optional<std::size_t>> light_of(const Pass& pass, const PassModel& model) {
    if (pass.lights != PassLights::First) return std::optional<std::size_t>{};
    const auto& lights = model.scene->lights;
    const auto casts = [](const scene::Light& light) {
        return light.shadow != scene::Shadow::None;
    };
    const auto first = std::find_if(lights.begin(), lights.end(), casts);
    if (first != lights.end()) return std::size_t(first - lights.begin());
    if (pass.action == PassAction::Shadow) return std::nullopt;
    return std::optional<std::size_t>{};
}

void count_repeats(std::vector<Step>& steps) {
    const auto glares = [](const Step& s) { return s.pass.objects == PassObjects::Glaring; };
    const auto count = std::size_t(std::count_if(
        steps.begin(), steps.end(), [&](const Step& s) { return glares(s) && s.map == 0; }));
    for (Step& step : steps)
        if (glares(step)) step.repeats = count;
}

}  // namespace

std::vector<Step> schedule(const PassList& passes, const PassModel& model) {
    std::vector<Step> steps;
    for (auto pass = passes.begin(); pass != passes.end();) {
        if (pass->lights != PassLights::Each) {
            if (const auto light = light_of(*pass, model)) add_runs(steps, *pass, *light, model);
            ++pass;
            continue;
        }
        const auto last = std::find_if(pass, passes.end(),
                                       [](const Pass& p) { return p.lights != PassLights::Each; });
        for (std::size_t light = 0; light < model.scene->lights.size(); ++light)
            std::for_each(pass, last, [&](const Pass& p) { add_runs(steps, p, light, model); });
        pass = last;
    }
    count_repeats(steps);
    return steps;
}

std::string name_of(const Step& step, const PassModel& model) {
    std::string name = step.pass.name.str();
    if (step.light) {
        const std::string& light = model.scene->lights[*step.light].name;
        name += " " + (light.empty() ? "light " + std::to_string(*step.light + 1) : light);
    }
    if (step.map > 0) name += " map " + std::to_string(step.map + 1);
    return name;
}

bool adds(const Step& step, const Part& part, const PassModel& model) {
    if (!selected(step.pass, part) || !has_map(step, part)) return false;
    const Material material = material_for(step.pass.material, *part.material);
    if (!step.light) return !is_black(material);
    const scene::Light& light = model.scene->lights[*step.light];
    return scene::lights_object(light, *part.object) && !is_black(lit(material, light));
}

bool concerns(const Step& step, const Part& part, const PassModel& model) {
    const bool dims =
        step.pass.blend.enable && step.pass.blend.dst == BlendFactor::OneMinusSrcAlpha;
    if (dims || is_black(step.pass.material)) return selected(step.pass, part);
    return adds(step, part, model);
}

bool is_needed(const Step& step, const PassModel& model) {
    const bool black = is_black(step.pass.material);
    return step.pass.clear || step.pass.action != PassAction::Draw ||
           std::any_of(model.parts.begin(), model.parts.end(), [&](const Part& part) {
               return black ? selected(step.pass, part) : adds(step, part, model);
           });
}

}  // namespace gw::multipass
