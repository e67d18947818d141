// The passes of the Hitachi paper as data [K3p]: what is drawn, under which tests, blended how.
// Does not choose among them: passes.h does.
#pragma once

#include "multipass/pass.h"

namespace gw::multipass {

/// Compare with the Z that the depth pass left, update nothing: what is drawn is what is seen [K3.3].
inline constexpr DepthState seen{.test = true, .func = DepthFunc::Equal, .mask = false};
/// Sum of the components in the frame buffer [K3 eq. 2].
inline constexpr BlendState add{.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One};
/// shadow_i(x, y) of eq. 4 [K3.2]: the shadow pass left 0 where the light arrives.
inline constexpr StencilState outside_shadow{.test = true, .func = StencilFunc::Equal, .ref = 0};

/// Z of all shapes, before all else [K3.3].
inline constexpr Pass depth_pass{
    .name = "depth",
    .clear = true,
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = 0},
    .depth = {.test = true, .func = DepthFunc::Less, .mask = true},
    .color = false,
};

/// The pixels in the shadow of the light [K3.2]. A light without shadow skips it.
inline constexpr Pass shadow_pass{
    .name = "shadow",
    .action = PassAction::Shadow,
    .color = false,
    .lights = PassLights::Each,
};

/// Ia_i Ka Mapa(s, t): in the shadow too.
inline constexpr Pass ambient_pass{
    .name = "ambient",
    .material = {.Ka = object, .Kd = 0, .Ks = 0, .Ke = 0, .Map = ambient_map},
    .depth = seen,
    .blend = add,
    .lights = PassLights::Each,
};

/// shadow_i Id_i Kd cos(theta) Mapd(s, t).
inline constexpr Pass diffuse_pass{
    .name = "diffuse",
    .material = {.Ka = 0, .Kd = object, .Ks = 0, .Ke = 0, .Map = diffuse_map},
    .depth = seen,
    .stencil = outside_shadow,
    .blend = add,
    .lights = PassLights::Each,
};

/// shadow_i Is_i Ks cos(alpha)^n Maps(s, t).
inline constexpr Pass specular_pass{
    .name = "specular",
    .material = {.Ka = 0, .Kd = 0, .Ks = object, .Ke = 0, .Map = specular_map},
    .depth = seen,
    .stencil = outside_shadow,
    .blend = add,
    .lights = PassLights::Each,
};

/// Ks Mape(s, t), once. The paper's tuple has Ke = 1, its eq. 2 Ks: docs/papers.md, readings.
inline constexpr Pass reflection_pass{
    .name = "reflection",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object_Ks, .Map = reflection_map},
    .depth = seen,
    .blend = add,
};

/// Tf Map(s, t) by the refracted ray [K1], once.
inline constexpr Pass refraction_pass{
    .name = "refraction",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object_Tf, .Map = refraction_map},
    .depth = seen,
    .blend = add,
};

/// The object's own light, once. No tuple of the paper draws it: docs/papers.md, readings.
inline constexpr Pass emission_pass{
    .name = "emission",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object, .Map = emission_map},
    .depth = seen,
    .blend = add,
};

/// Eq. 1 [K2]: everything in one pass, all lights, one map that modulates all of it.
inline constexpr Pass hardware_pass{
    .name = "hardware",
    .clear = true,
    .material = {.Ka = object, .Kd = object, .Ks = object, .Ke = object, .Map = object_map},
    .depth = {.test = true, .func = DepthFunc::Less, .mask = true},
    .lights = PassLights::All,
};

}  // namespace gw::multipass
