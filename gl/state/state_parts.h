// The parts of the machine's state that are made anew by themselves, and the groups of GL's state that
// each follows from. A change of one field makes one or two parts anew.
#pragma once

#include "gl/state/state.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace gw::gl {

enum StateParts : std::uint8_t {
    no_state_part = 0,
    transform_part = 1,
    lighting_part = 2,  ///< and the lights
    shape_part = 4,     ///< of points, lines and polygons
    texture_part = 8,
    fog_part = 16,
    fragment_part = 32,  ///< and what is drawn to
    all_state_parts = 63,
};
constexpr StateParts operator|(StateParts a, StateParts b) {
    return StateParts(std::uint8_t(a) | std::uint8_t(b));
}

/// The parts that follow from a field; all if it is not one of the groups below.
inline StateParts parts_of(const State& state, const void* field) {
    const auto is_in = [field](const auto& group) {
        const std::less<const void*> is_before;
        return !is_before(field, &group) && is_before(field, &group + 1);
    };
    if (is_in(state.color_buffer) || is_in(state.depth) || is_in(state.stencil) ||
        is_in(state.scissor))
        return fragment_part;
    if (is_in(state.texture)) return texture_part;
    if (is_in(state.lighting)) return lighting_part;
    if (is_in(state.transform)) return transform_part;
    if (is_in(state.fog)) return fog_part;
    if (is_in(state.line) || is_in(state.polygon) || is_in(state.polygon_stipple))
        return shape_part;
    if (is_in(state.point)) return shape_part | texture_part;
    return all_state_parts;
}

}  // namespace gw::gl
