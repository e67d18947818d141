// The passes of the Hitachi paper as data [K3p]: their parameters, tests and blending. Does not
// choose among them: passes.h does.
#pragma once

#include "multipass/passes/pass.h"

namespace gw::multipass {

/// Compare with the Z that the depth pass left, update nothing: only visible surfaces are drawn
/// [K3.3].
inline constexpr DepthState seen{.test = true, .func = DepthFunc::Equal, .mask = false};
/// Sum of the components in the frame buffer [K3 eq. 2].
inline constexpr BlendState add{.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One};
/// shadow_i(x, y) of eq. 4 [K3.2]: the shadow pass left 0 on lit pixels.
inline constexpr StencilState outside_shadow{.test = true, .func = StencilFunc::Equal, .ref = 0};

/// The first pass of a picture clears these.
inline constexpr PlaneMask picture =
    mask_of(Plane::Color) | mask_of(Plane::Depth) | mask_of(Plane::Stencil);

/// Z of all shapes, before all else [K3.3].
inline const Pass depth_pass{
    .name = "depth",
    .clear = picture,
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = 0},
    .depth = {.test = true, .func = DepthFunc::Less, .mask = true},
    .color = false,
};

/// The pixels in the shadow of the light [K3.2]. A light without shadow skips it.
inline const Pass shadow_pass{
    .name = "shadow",
    .action = PassAction::Shadow,
    .lights = PassLights::Each,
};

/// Ia_i Ka Mapa(s, t): in the shadow too.
inline const Pass ambient_pass{
    .name = "ambient",
    .material = {.Ka = object, .Kd = 0, .Ks = 0, .Ke = 0, .Map = ambient_map},
    .depth = seen,
    .blend = add,
    .lights = PassLights::Each,
};

/// shadow_i Id_i Kd cos(theta) Mapd(s, t).
inline const Pass diffuse_pass{
    .name = "diffuse",
    .material = {.Ka = 0, .Kd = object, .Ks = 0, .Ke = 0, .Map = diffuse_map},
    .depth = seen,
    .stencil = outside_shadow,
    .blend = add,
    .lights = PassLights::Each,
};

/// shadow_i Is_i Ks cos(alpha)^n Maps(s, t).
inline const Pass specular_pass{
    .name = "specular",
    .material = {.Ka = 0, .Kd = 0, .Ks = object, .Ke = 0, .Map = specular_map},
    .depth = seen,
    .stencil = outside_shadow,
    .blend = add,
    .lights = PassLights::Each,
};

/// Ks Mape(s, t), once. The paper's tuple has Ke = 1, its eq. 2 Ks: docs/papers.md, readings.
inline const Pass reflection_pass{
    .name = "reflection",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object_Ks, .Map = reflection_map},
    .depth = seen,
    .blend = add,
};

/// Tf Map(s, t) by the refracted ray [K1], once.
inline const Pass refraction_pass{
    .name = "refraction",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object_Tf, .Map = refraction_map},
    .depth = seen,
    .blend = add,
};

/// The object's own light, once. No tuple of the paper draws it: docs/papers.md, readings.
inline const Pass emission_pass{
    .name = "emission",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object, .Map = emission_map},
    .depth = seen,
    .blend = add,
};

/// I_raytracing(x, y) of eq. 5 [K4], once: the light along rays, through the first hit's black fog.
inline const Pass trace_pass{
    .name = "raytracing",
    .action = PassAction::Trace,
    .blend = add,
};

/// Fog, step 2 [K3.5]: black objects in fog of its colour, shadow or not. All passes before went
/// through black fog.
inline const Pass fog_pass{
    .name = "fog",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = 0},
    .depth = seen,
    .blend = add,
    .fog = PassFog::Scene,
};

/// Adds the image drawn so far to the accumulation buffer; the next image begins black.
inline const Pass add_pass{.name = "add", .action = PassAction::Add};

/// Light around emitters [K3.3]: each once more, moved, once a pixel; the mean of the superposed
/// pictures glows. An image of its own [add_pass], so that the sum with the scene is not clamped in
/// each picture. If Ke times the strength is more than 1, the pass is repeated, each time with its
/// part of the strength.
inline const Pass glare_pass{
    .name = "glare",
    .clear = mask_of(Plane::Stencil),
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object, .Map = emission_map},
    .depth = {.test = true, .func = DepthFunc::Less, .mask = false},
    .stencil = {.test = true, .func = StencilFunc::Equal, .ref = 0, .zpass = StencilOp::Incr},
    .blend = add,
    .objects = PassObjects::Glaring,
};

/// Eq. 1 [K2]: everything in one pass, all lights, one map that modulates all of it.
inline const Pass hardware_pass{
    .name = "hardware",
    .clear = picture,
    .material = {.Ka = object, .Kd = object, .Ks = object, .Ke = object, .Map = object_map},
    .depth = {.test = true, .func = DepthFunc::Less, .mask = true},
    .lights = PassLights::All,
};

/// Before the opaque surface, without changing its Z [K3.4].
inline constexpr DepthState in_front{.test = true, .func = DepthFunc::Less, .mask = false};
/// Over the surfaces behind.
inline constexpr BlendState over{
    .enable = true, .src = BlendFactor::SrcAlpha, .dst = BlendFactor::OneMinusSrcAlpha};

/// Only on pixels that have the layer being drawn (translucency.h).
inline constexpr StencilState in_layer{.test = true, .func = StencilFunc::Equal, .ref = 1};

/// Translucent objects dim the surfaces behind them [K3.4]: the opaque picture first ...
inline const Pass veil_pass{
    .name = "veil",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = 0},
    .depth = in_front,
    .blend = {.enable = true, .src = BlendFactor::Zero, .dst = BlendFactor::OneMinusSrcAlpha},
    .objects = PassObjects::Translucent,
};

/// ... then each component is an image of its own: the component of all translucent objects, far to
/// near, on black.
inline const Pass translucent_ambient_pass{
    .name = "translucent ambient",
    .material = {.Ka = object, .Kd = 0, .Ks = 0, .Ke = 0, .Map = ambient_map},
    .depth = in_front,
    .blend = over,
    .lights = PassLights::Each,
    .objects = PassObjects::Translucent,
};
inline const Pass translucent_diffuse_pass{
    .name = "translucent diffuse",
    .material = {.Ka = 0, .Kd = object, .Ks = 0, .Ke = 0, .Map = diffuse_map},
    .depth = in_front,
    .blend = over,
    .lights = PassLights::Each,
    .objects = PassObjects::Translucent,
};
inline const Pass translucent_specular_pass{
    .name = "translucent specular",
    .material = {.Ka = 0, .Kd = 0, .Ks = object, .Ke = 0, .Map = specular_map},
    .depth = in_front,
    .blend = over,
    .lights = PassLights::Each,
    .objects = PassObjects::Translucent,
};
inline const Pass translucent_reflection_pass{
    .name = "translucent reflection",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object_Ks, .Map = reflection_map},
    .depth = in_front,
    .blend = over,
    .objects = PassObjects::Translucent,
};
inline const Pass translucent_refraction_pass{
    .name = "translucent refraction",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object_Tf, .Map = refraction_map},
    .depth = in_front,
    .blend = over,
    .objects = PassObjects::Translucent,
};
inline const Pass translucent_emission_pass{
    .name = "translucent emission",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = object, .Map = emission_map},
    .depth = in_front,
    .blend = over,
    .objects = PassObjects::Translucent,
};
/// Black material with the object's own alpha: docs/papers.md, readings.
inline const Pass translucent_fog_pass{
    .name = "translucent fog",
    .material = {.Ka = 0, .Kd = 0, .Ks = 0, .Ke = 0},
    .depth = in_front,
    .blend = over,
    .fog = PassFog::Scene,
    .objects = PassObjects::Translucent,
};
/// Eq. 1 over the surfaces behind.
inline const Pass translucent_hardware_pass{
    .name = "translucent hardware",
    .material = {.Ka = object, .Kd = object, .Ks = object, .Ke = object, .Map = object_map},
    .depth = in_front,
    .blend = over,
    .lights = PassLights::All,
    .objects = PassObjects::Translucent,
};

}  // namespace gw::multipass
