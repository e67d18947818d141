// Materials and lights, in the papers' words. docs/manual/lighting.md.
// Does not evaluate the lighting equation: gw/stages/lighting.h does.
#pragma once

#include "gw/base/types.h"

#include <memory>
#include <vector>

namespace gw {

/// A surface's parameters [K2]; R, G, B, each usually in 0 .. 1.
struct Material {
    vec3 Ka{0.2f, 0.2f, 0.2f};
    vec3 Kd{0.8f, 0.8f, 0.8f};
    vec3 Ks{0, 0, 0};
    vec3 Ke{0, 0, 0};  ///< emission, independent of every light
    float Ns = 0;      ///< exponent n of the highlight, 0 .. 10000
    float alpha = 1;   ///< of the lit colour (d in MTL)
    bool operator==(const Material&) const = default;
};

/// The materials of a vertex's two sides.
struct FaceMaterials {
    Material front, back;
    bool operator==(const FaceMaterials&) const = default;
};

/// A light in EYE space. Directional if position.w == 0: position.xyz points TOWARDS the light.
struct Light {
    vec4 position{0, 0, 1, 0};
    vec3 Ia{0, 0, 0};
    vec3 Id{1, 1, 1};
    vec3 Is{1, 1, 1};
    vec3 spot_direction{0, 0, -1};
    float spot_exponent = 0;  ///< 0 .. 128
    /// cosine of the cone's half angle; -1: no cone
    float spot_cos_cutoff = -1;
    float constant_attenuation = 1, linear_attenuation = 0, quadratic_attenuation = 0;
    bool operator==(const Light&) const = default;
};

/// The lights of one draw, shared by many draws. Null means none.
using LightsRef = std::shared_ptr<const std::vector<Light>>;

}  // namespace gw
