// Which draws share the values at the vertices of a set.
#include "gw/command_list.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/stages/vertex.h"

#include <algorithm>

namespace gw::fast {
namespace {

bool same_lights(const LightsRef& a, const LightsRef& b) { return a == b || (a && b && *a == *b); }

bool same_back(const Draw& a, const Draw& b) {
    return a.back_material == b.back_material ||
           (a.back_material && b.back_material && *a.back_material == *b.back_material);
}

/// The inputs of fog: its state without the colour.
bool same_factors(FogState a, const FogState& b) {
    a.color = b.color;
    return a == b;
}

bool is_lit(const State& s) { return s.color_source == ColorSource::Lighting; }

/// Whether both have colours of back faces, and secondary ones, or neither.
bool same_lists(const State& a, const State& b) {
    return is_lit(a) == is_lit(b) && sums_colors(a) == sums_colors(b) &&
           (!is_lit(a) || a.lighting.two_side == b.lighting.two_side);
}

bool same_lighting(const State& a, const State& b, std::size_t) {
    return a.color_source == b.color_source && same_lists(a, b) &&
           (!is_lit(a) || (a.lighting == b.lighting && a.normalize == b.normalize));
}
bool same_surface(const Draw& a, const Draw& b, const State& state, std::size_t) {
    return same_current(a, b) && (!is_lit(state) || (a.material == b.material && same_back(a, b) &&
                                                     same_lights(a.lights, b.lights)));
}

bool same_fog_factors(const State& a, const State& b, std::size_t) {
    return same_factors(a.fog, b.fog);
}
bool same_fog_coordinates(const Draw& a, const Draw& b, const State& state, std::size_t) {
    return state.fog.source == FogSource::Depth || same_current(a, b);
}

bool same_generation(const State& a, const State& b, std::size_t unit) {
    const TextureState &s = texture_of(a, unit), &t = texture_of(b, unit);
    return s.gen == t.gen && (s.gen != TexGen::RefractionMap || s.eta == t.eta) &&
           (s.gen != TexGen::EyeLinear || s.eye_linear == t.eye_linear) &&
           (s.gen != TexGen::PerCoordinate || s.coordinates == t.coordinates) &&
           s.matrix == t.matrix && a.normalize == b.normalize;
}
bool same_given_texcoords(const Draw& a, const Draw& b, const State&, std::size_t unit) {
    return same_current(a, b) && is_one_dimensional(a, unit) == is_one_dimensional(b, unit);
}

}  // namespace

const SameValues same_colors{same_lighting, same_surface};
const SameValues same_fog{same_fog_factors, same_fog_coordinates};
const SameValues same_texcoords{same_generation, same_given_texcoords};

void VertexInputs::begin(const GroupDraws& group) {
    set = group.group.set;
    first = group.state;
    newest = nullptr;
    unit = group.unit;
    draws.assign(set->parts.size(), nullptr);
    states.assign(set->parts.size(), nullptr);
}

void VertexInputs::add(const GroupDraws& group, const SameValues& same) {
    if (!newest || !same.of_states(*newest, *group.state, unit)) newest = group.state;
    const std::size_t first_part = group.group.first_part;
    std::copy_n(group.draws, group.group.parts, draws.begin() + std::ptrdiff_t(first_part));
    std::fill_n(states.begin() + std::ptrdiff_t(first_part), group.group.parts, newest);
}

bool VertexInputs::has_room_for(const GroupDraws& group) const {
    const auto begin = draws.begin() + group.group.first_part;
    return unit == group.unit && same_lists(*first, *group.state) &&
           std::all_of(begin, begin + group.group.parts, [](const Draw* draw) { return !draw; });
}

bool VertexInputs::has_values_of(const GroupDraws& group, const SameValues& same) const {
    const State* compared = group.state;
    for (std::size_t i = 0; i < group.group.parts; ++i) {
        const std::size_t part = group.group.first_part + i;
        const State* const state = states[part];
        if (!draws[part] ||
            (state != compared && !same.of_states(*state, *group.state, group.unit)) ||
            !same.of_draws(*draws[part], *group.draws[i], *group.state, group.unit))
            return false;
        compared = state;
    }
    return set == group.group.set && unit == group.unit;
}

bool VertexColors::is_uniform(const PartGroup& group) const {
    const auto first = uniform.begin() + group.first_part;
    return std::find(first, first + group.parts, 0) == first + group.parts;
}

}  // namespace gw::fast
