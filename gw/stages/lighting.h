// The lighting equation at a vertex: equation 1 of [K2] without the map. Each component of equation
// 2 [K3] is this equation with the other components 0. docs/manual/lighting.md. Does not transform.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

#include <array>

namespace gw {

/// The factors of a light's Ia, Id and Is: attenuation and cone a, a cos(theta), a cos(alpha)^n.
/// Not clamped.
struct LightTerms {
    double ambient = 0, diffuse = 0, specular = 0;
};
/// `n_eye` and `to_eye` have length 1. `specular` is computed only with `gloss`.
LightTerms light_terms(const Light& light, const dvec3& p_eye, const dvec3& n_eye,
                       const dvec3& to_eye, double exponent, bool gloss);

/// A lit colour R, G, B, A and its highlights, which are 0 unless they are separate. Integers 0 ..
/// 2^color_bits - 1, first rounded to lit_bits.
struct LitColors {
    std::array<double, 4> color{}, secondary{};
};
/// Those of a vertex in eye space.
LitColors lit_colors(const Material& material, const LightsRef& lights, const LightingState& state,
                     const Profile& profile, const dvec3& p_eye, const dvec3& n_eye);

}  // namespace gw
