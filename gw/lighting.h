// The lighting equation at a vertex: eq. 1 of [K2] without the map, and every component of eq. 2 [K3] by
// zeroing others. docs/manual.md, "Lighting". Does not transform, does not interpolate.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

#include <array>

namespace gw {

/// Lit colour of a vertex in eye space, n_eye of length 1 or 0. Integers 0 .. 2^color_bits - 1 that passed
/// through lit_bits, alpha last.
std::array<double, 4> lit_color(const Draw& draw, const LightingState& state, const Profile& profile,
                                const dvec3& p_eye, const dvec3& n_eye);

}  // namespace gw
