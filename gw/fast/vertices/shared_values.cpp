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

/// Whether parts that have a draw already have one for which same(theirs, ours) is true.
bool same_given(const VertexInputs& a, const GroupDraws& b, const auto& same) {
    for (std::size_t i = 0; i < b.group.parts; ++i) {
        const Draw* const draw = a.draws[b.group.first_part + i];
        if (draw && !same(*draw, *b.draws[i])) return false;
    }
    return true;
}

/// The inputs of fog: its state without the colour.
bool same_factors(FogState a, const FogState& b) {
    a.color = b.color;
    return a == b;
}

}  // namespace

void VertexInputs::begin(const GroupDraws& group) {
    set = group.group.set;
    state = group.state;
    unit = group.unit;
    draws.assign(set->parts.size(), nullptr);
}

void VertexInputs::add(const GroupDraws& group) {
    std::copy_n(group.draws, group.group.parts, draws.begin() + group.group.first_part);
}

bool VertexInputs::has_room_for(const PartGroup& group) const {
    const auto first = draws.begin() + group.first_part;
    return std::all_of(first, first + group.parts, [](const Draw* draw) { return !draw; });
}

bool VertexColors::is_uniform(const PartGroup& group) const {
    const auto first = uniform.begin() + group.first_part;
    return std::find(first, first + group.parts, 0) == first + group.parts;
}

bool same_lighting(const VertexInputs& a, const GroupDraws& b) {
    return a.set == b.group.set && a.state->color_source == b.state->color_source &&
           sums_colors(*a.state) == sums_colors(*b.state) &&
           (a.state->color_source != ColorSource::Lighting ||
            (a.state->lighting == b.state->lighting && a.state->normalize == b.state->normalize));
}

bool same_colors(const VertexInputs& a, const GroupDraws& b) {
    if (!same_lighting(a, b)) return false;
    for (std::size_t i = 0; i < b.group.parts; ++i) {
        const Draw* const draw = a.draws[b.group.first_part + i];
        if (!draw || !same_current(*draw, *b.draws[i])) return false;
        if (a.state->color_source == ColorSource::Lighting &&
            !(draw->material == b.draws[i]->material && same_back(*draw, *b.draws[i]) &&
              same_lights(draw->lights, b.draws[i]->lights)))
            return false;
    }
    return true;
}

bool same_fog(const VertexInputs& a, const GroupDraws& b) {
    return a.set == b.group.set && same_factors(a.state->fog, b.state->fog) &&
           (a.state->fog.source == FogSource::Depth || same_given(a, b, same_current));
}

bool same_texcoords(const VertexInputs& a, const GroupDraws& b) {
    const TextureState &s = texture_of(*a.state, b.unit), &t = texture_of(*b.state, b.unit);
    return a.set == b.group.set && a.unit == b.unit && s.gen == t.gen &&
           (s.gen != TexGen::RefractionMap || s.eta == t.eta) &&
           (s.gen != TexGen::EyeLinear || s.eye_linear == t.eye_linear) &&
           (s.gen != TexGen::PerCoordinate || s.coordinates == t.coordinates) &&
           s.matrix == t.matrix && a.state->normalize == b.state->normalize &&
           same_given(a, b, [&](const Draw& x, const Draw& y) {
               return same_current(x, y) &&
                      is_one_dimensional(x, b.unit) == is_one_dimensional(y, b.unit);
           });
}

}  // namespace gw::fast
