#include "multipass/steps/commands.h"

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
    if (f.mode != FogMode::Linear && f.density == 0) return;  // the machine has no fog of density 0
    const vec3 color = fog == PassFog::Black ? vec3(0) : f.color;
    state.fog = {.enable = true,
                 .mode = f.mode,
                 .density = f.density,
                 .start = f.start,
                 .end = f.end,
                 .color = vec4(color, 1)};
}

/// Visits whole parts, or pieces from far to near if a translucent pass needs an order.
template <class Visit>
void for_each_portion(const PlacedModel& placed, const Step& step, const Visit& visit) {
    const auto& parts = placed.model->parts;
    const bool sorted =
        step.pass.objects == PassObjects::Translucent && step.pass.depth.func != DepthFunc::Equal;
    if (sorted && !placed.far_to_near.empty()) {
        for (const Portion& portion : placed.far_to_near)
            if (concerns(step, parts[portion.part], *placed.model)) visit(portion);
        return;
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (concerns(step, parts[i], *placed.model)) visit(Portion{.part = i});
}

}  // namespace

void cut_if_long(CommandList& list, const FrameRules& rules) {
    constexpr std::size_t long_list = 1 << 16;
    if (rules.cut && list.commands.size() >= long_list) rules.cut(list);
}

void begin_pass(CommandList& list, const std::string& name, const State& state) {
    list.add(BeginPass{.name = name});
    list.add(SetState{state});
}

void add_whole_window(CommandList& list, State state) {
    // A triangle around the window of any view.
    static const MeshRef triangle = make_mesh({.positions = {{-2, -2, 1}, {6, -2, 1}, {-2, 6, 1}}});
    state.projection = dmat4(1);
    state.clip_planes = {};
    state.cull = {};
    state.color_source = ColorSource::Vertex;
    list.add(SetState{state});
    list.add(Draw{.mesh = triangle});
}

State state_of(const PlacedModel& placed, const Step& step) {
    State state = placed.state;
    const Pass& pass = step.pass;
    state.depth = pass.depth;
    state.stencil = pass.stencil;
    state.blend = pass.blend;
    // A pass that dims the picture behind leaves its alpha as it is.
    const bool dims = pass.blend.enable && pass.blend.dst == BlendFactor::OneMinusSrcAlpha;
    state.color_mask = {pass.color, pass.color, pass.color, pass.color && !dims};
    set_fog(state, pass.fog, *placed.model->scene);
    return state;
}

TextureState lookup_of(const PlacedModel& placed, const Step& step, std::size_t index) {
    const Part& part = placed.model->parts[index];
    const MappedMesh* map = adds(step, part, *placed.model) ? map_of(step, part) : nullptr;
    if (!map) return {};
    TextureState lookup = map->lookup;
    if (placed.mesh_of(index, *map) != map->mesh) lookup.gen = TexGen::None;
    return lookup;
}

Draw draw_of(const PlacedModel& placed, const Step& step, const Portion& portion) {
    const Part& part = placed.model->parts[portion.part];
    if (!adds(step, part, *placed.model)) return black_draw(placed, portion);
    const MappedMesh* map = map_of(step, part);
    Draw draw{.mesh = portion.of(map ? placed.mesh_of(portion.part, *map) : part.mesh),
              .eye_from_object = placed.eye_from_object[portion.part]};
    draw.material = material_for(step.pass.material, *part.material);
    if (step.light) draw.lights = placed.lights[*step.light];
    if (step.pass.lights == PassLights::All) draw.lights = lights_of(placed, part);
    if (map) draw.map.texture = map->texture;
    if (step.pass.objects == PassObjects::Glaring) {
        draw.eye_from_object[3] += dvec4(placed.glare[portion.part], 0);
        draw.material.Ke *= part.object->glare->strength / float(step.repeats);
    }
    return draw;
}

Draw black_draw(const PlacedModel& placed, const Portion& portion) {
    const Part& part = placed.model->parts[portion.part];
    Draw draw{.mesh = portion.of(part.mesh),
              .eye_from_object = placed.eye_from_object[portion.part]};
    draw.material = material_for({}, *part.material);
    return draw;
}

void begin_step(CommandList& list, StateWriter& states, const PlacedModel& placed, const Step& step,
                const FrameRules& rules) {
    list.add(BeginPass{.name = name_of(step, *placed.model)});
    if (!step.pass.clear) return;
    State all = state_of(placed, step);
    all.color_mask = {};
    all.depth.mask = true;
    all.stencil.write_mask = ~0u;
    states.set(all);
    list.add(Clear{.planes = step.pass.clear, .color = vec4(rules.background, 1)});
}

void draw_step(CommandList& list, StateWriter& states, const PlacedModel& placed, const Step& step,
               State state, const FrameRules& rules) {
    for_each_portion(placed, step, [&](const Portion& portion) {
        state.texture = lookup_of(placed, step, portion.part);
        state.cull = placed.cull[portion.part];
        states.set(state);
        list.add(draw_of(placed, step, portion));
        cut_if_long(list, rules);
    });
}

void add_step(CommandList& list, const PlacedModel& placed, const Step& step,
              const FrameRules& rules) {
    if (!is_needed(step, *placed.model)) return;
    StateWriter states(list);
    begin_step(list, states, placed, step, rules);
    draw_step(list, states, placed, step, state_of(placed, step), rules);
}

}  // namespace gw::multipass
