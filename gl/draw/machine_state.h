// GL's state in the machine's words. One function a group; enumerations are translated in one table
// each. What a profile lacks is left out, so that the machine draws what it can.
#pragma once

#include "gl/state/matrices.h"
#include "gl/state/state.h"
#include "gl/state/texture_objects.h"
#include "gw/command_list.h"
#include "gw/profile.h"

namespace gw::gl {

struct Context;

gw::State machine_state(const Context& context);

/// The depth 0 .. 1 of z / w.
double window_depth(double z, const gw::State& state);

/// How units 1 to 3 make texture coordinates, whether they have textures or not.
gw::MoreTextures further_coordinates(const Context& context);

/// Null if no light is enabled.
LightsRef machine_lights(const LightingState& lighting);

gw::Material machine_material(const MaterialState& m);

}  // namespace gw::gl
