// GL's state in the machine's words. One function a group; enumerations are translated in one table
// each. What a profile lacks is left out, so that the machine draws what it can.
#pragma once

#include "gl/state/matrices.h"
#include "gl/state/state.h"
#include "gl/state/state_parts.h"
#include "gl/state/texture_objects.h"
#include "gw/command_list.h"
#include "gw/profile.h"

namespace gw::gl {

struct Context;

/// Makes parts of the machine's state anew. Texture coordinates are scaled for the machine; in
/// feedback they stay OpenGL's.
void translate_state(const Context& context, StateParts parts, gw::State& out);

/// The depth 0 .. 1 of z / w.
double window_depth(double z, const gw::State& state);

/// What makes s and t of a unit's texture 0 .. 1. Those of rectangles count texels; else it is 1.
dvec2 coordinate_scale(const Context& context, std::size_t unit);

/// A coordinate s or t of a rectangle with q, as the machine's: moved by a quarter of a filter's least
/// weight, so that rounding leaves it at the texel where it is.
constexpr double rectangle_coordinate(double texels, double q, double scale) {
    return (texels + q / 1024) * scale;
}

/// How units 1 to 3 make texture coordinates, whether they have textures or not.
gw::MoreTextures further_coordinates(const Context& context);

/// Null if no light is enabled.
LightsRef machine_lights(const LightingState& lighting);

gw::Material machine_material(const MaterialState& m);

}  // namespace gw::gl
