// The components of an object's colour [K3], and eq. 3 [K3s]: their sum at one point, for renderers
// that shade pixels or rays. Does not determine visibility, follow rays or cast shadows: the caller
// says how much light arrives.
#pragma once

#include "gw/material.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace gw::scene {

/// The components of an object's colour [K3], each with its material parameters and maps.
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

/// A visible point of a surface, in the space of the lights: eye space for the machine's.
struct SurfacePoint {
    dvec3 p{0};
    dvec3 n{0, 0, 1};       ///< length 1, on the side that is seen
    dvec3 to_eye{0, 0, 1};  ///< length 1
    dvec2 st{0};
    /// change of st from one pixel to the next; 0: the finest level is looked up
    dvec2 st_dx{0}, st_dy{0};
};

/// A map's colour at st with the map's scale, offset and wrap: the mean of the two pyramid levels
/// around the footprint, four texels of each, in double. White if it has no texture.
dvec3 sample(const Map& map, const dvec2& st, const dvec2& st_dx = dvec2(0),
             const dvec2& st_dy = dvec2(0));

/// The sum of the component's maps at the point [K3.1]; white without one. Reflection and
/// refraction maps are looked up as sphere maps in eye space, and black without one.
dvec3 map_color(const Material& material, Component component, const SurfacePoint& point);

/// Sum of the sphere maps in direction `d` (eye space, length 1): the surroundings far away.
dvec3 far_color(std::span<const Map> maps, const dvec3& d);

/// map_color of the components that lights have, each looked up at most once. Refers to both.
class MapColors {
public:
    MapColors(const Material& material, const SurfacePoint& point)
        : material_(material), point_(point) {}
    const dvec3& of(Component component);

private:
    const Material& material_;
    const SurfacePoint& point_;
    std::optional<dvec3> ambient_, diffuse_, specular_;
};

/// One light's part: Ia Ka Mapa + arrives (Id Kd cos(theta) Mapd + Is Ks cos(alpha)^n Maps). [K3,
/// K3.2]
dvec3 light_color(const Material& material, const gw::Light& light, const SurfacePoint& point,
                  double arrives = 1);
/// The same, for several lights at one point. `maps` are of the same material and point.
dvec3 light_color(const Material& material, const gw::Light& light, const SurfacePoint& point,
                  MapColors& maps, double arrives = 1);

/// The part that needs no light: Ke, Ks Mape, and Tf times the refraction map.
dvec3 own_color(const Material& material, const SurfacePoint& point);

/// Eq. 3: all of it, not clamped.
dvec3 shade(const Material& material, std::span<const gw::Light> lights, const SurfacePoint& point);

}  // namespace gw::scene
