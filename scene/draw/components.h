// The components of an object's colour [K3], each with its material parameters and maps. Does not
// evaluate them: the machine, eq. 3's shading and the ray tracer do.
#pragma once

#include "scene/scene.h"

#include <array>
#include <span>
#include <string_view>

namespace gw::scene {

enum class Component { Ambient, Diffuse, Specular, Reflection, Refraction, Emission };
inline constexpr std::array<Component, 6> components{Component::Ambient,    Component::Diffuse,
                                                     Component::Specular,   Component::Reflection,
                                                     Component::Refraction, Component::Emission};

/// "ambient" .. "emission": names of files and passes.
std::string_view name_of(Component component);

/// The coefficient of the component's maps: Ka, Kd, Ks, Ks again for the reflection map [K3 eq. 2],
/// Tf, Ke.
vec3 coefficient(const Material& material, Component component);

/// The component's maps. The ambient component of a material without map_Ka has its map_Kd, as is
/// usual [K3.1].
std::span<const Map> maps(const Material& material, Component component);

/// Whether the component can add anything. Reflection and refraction need a map; the others without
/// a map act as if theirs were white.
bool has_component(const Material& material, Component component);

/// The one map of eq. 1 [K2], which modulates everything: the first of map_Kd, map_Ka, map_Ks,
/// map_Ke; null if there is none.
const Map* hardware_map(const Material& material);

}  // namespace gw::scene
