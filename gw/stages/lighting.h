// The lighting equation at a vertex: eq. 1 of [K2] without the map, and every component of eq. 2
// [K3] by zeroing others. docs/manual.md, "Lighting". Does not transform, does not interpolate.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

#include <array>

namespace gw {

/// How much of a light's Ia, Id, Is a surface with Ka = Kd = Ks = 1 sends to the eye: attenuation
/// and cone, those times cos(theta), those times cos(alpha)^n. Not clamped.
struct LightTerms {
    double ambient = 0, diffuse = 0, specular = 0;
};
/// `n_eye` and `to_eye` of length 1. `specular` is worked out only where `gloss`.
LightTerms light_terms(const Light& light, const dvec3& p_eye, const dvec3& n_eye,
                       const dvec3& to_eye, double exponent, bool gloss);

/// Lit colour of a vertex in eye space, n_eye of length 1 or 0. Integers 0 .. 2^color_bits - 1 that
/// passed through lit_bits, alpha last.
std::array<double, 4> lit_color(const Draw& draw, const LightingState& state,
                                const Profile& profile, const dvec3& p_eye, const dvec3& n_eye);

}  // namespace gw
