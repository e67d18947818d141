// One step as commands.
#include "multipass/commands.h"

#include "multipass/one_winner.h"

#include <utility>

namespace gw::multipass {
namespace {

/// The map of this part in this step; none: it is drawn as if the map was white.
const MappedMesh* map_of(const Step& step, const Part& part) {
    const auto& maps = part.maps_for(step.pass.material.Map);
    return step.map < maps.size() ? &maps[step.map] : nullptr;
}

void set_fog(State& state, PassFog fog, const scene::Scene& scene) {
    if (fog == PassFog::None || !scene.fog) return;
    const scene::Fog& f = *scene.fog;
    const vec3 color = fog == PassFog::Black ? vec3(0) : f.color;
    state.fog = {.enable = true,
                 .mode = f.mode,
                 .density = f.density,
                 .start = f.start,
                 .end = f.end,
                 .color = vec4(color, 1)};
}

/// SetState where it differs from the one before.
class StateWriter {
public:
    explicit StateWriter(CommandList& list) : list_(&list) {}
    void set(const State& state) {
        if (last_ && *last_ == state) return;
        list_->add(SetState{state});
        last_ = state;
    }

private:
    CommandList* list_;
    std::optional<State> last_;
};

std::vector<std::size_t> parts_concerned(const Stage& stage, const Step& step) {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < stage.model->parts.size(); ++i)
        if (concerns(step, stage.model->parts[i], *stage.model)) parts.push_back(i);
    return parts;
}

}  // namespace

State state_of(const Stage& stage, const Step& step) {
    State state = stage.state;
    const Pass& pass = step.pass;
    state.depth = pass.depth;
    state.stencil = pass.stencil;
    state.blend = pass.blend;
    state.color_mask = {pass.color, pass.color, pass.color, pass.color};
    set_fog(state, pass.fog, *stage.model->scene);
    return state;
}

TextureState lookup_of(const Stage& stage, const Step& step, std::size_t part) {
    const MappedMesh* map = map_of(step, stage.model->parts[part]);
    return map ? map->lookup : TextureState{};
}

Draw draw_of(const Stage& stage, const Step& step, std::size_t index) {
    const Part& part = stage.model->parts[index];
    const MappedMesh* map = map_of(step, part);
    Draw draw{.mesh = map ? map->mesh : part.mesh, .eye_from_object = stage.eye_from_object[index]};
    draw.material = material_for(step.pass.material, *part.material);
    if (step.light) draw.lights = stage.lights[*step.light];
    if (step.pass.lights == PassLights::All) draw.lights = lights_of(stage, part);
    if (map) draw.map.texture = map->texture;
    return draw;
}

void add_step(CommandList& list, const Stage& stage, const Step& step, const FrameRules& rules) {
    const std::vector<std::size_t> parts = parts_concerned(stage, step);
    if (parts.empty() && !step.pass.clear) return;
    list.add(BeginPass{.name = name_of(step, *stage.model)});
    StateWriter states(list);
    State state = state_of(stage, step);
    if (step.pass.clear) {
        State all = state;
        all.color_mask = {};
        all.depth.mask = true;
        all.stencil.write_mask = ~0u;
        states.set(all);
        list.add(Clear{
            .planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth) | mask_of(Plane::Stencil)),
            .color = vec4(rules.background, 1)});
    }
    if (rules.one_winner && is_additive(step.pass)) {
        add_one_winner_step(list, stage, step, rules.stencil_bits);
        return;
    }
    for (const std::size_t i : parts) {
        state.texture = lookup_of(stage, step, i);
        states.set(state);
        list.add(draw_of(stage, step, i));
    }
}

}  // namespace gw::multipass
