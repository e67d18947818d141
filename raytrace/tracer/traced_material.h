// Which materials are traced, in MTL's words: illum 3 and up [K4, L9]. Does not follow rays
// (tracer.h).
#pragma once

#include "scene/scene.h"

namespace gw::raytrace {

/// The parts of light that a surface reflects and transmits, and the maps of far-away light.
///
///   illum   reflected light        transmitted light
///   3, 4    Ks                     (1 - d) Tf, bent by Ni
///   6       Ks                     (1 - d) Tf, bent by Ni
///   5, 7    F                      (1 - F) (1 - d) Tf, bent by Ni
///   others  not traced: reflection and refraction maps only
///
/// F = Ks + (1 - Ks) (1 - cos theta)^5 (Schlick 1994), theta on the side of the thinner medium: 1
/// from the critical angle on. If nothing is transmitted, theta is the ray's own. With the other
/// illum, total reflection turns transmitted light into reflected light. Ni = 1, its default, bends
/// nothing.
struct TracedMaterial {
    dvec3 reflect{0}, transmit{0};
    double Ni = 1;
    bool fresnel = false;
    const std::vector<scene::Map>* reflection_far = nullptr;  ///< refl; null: the background
    const std::vector<scene::Map>* refraction_far = nullptr;

    bool any() const { return reflect != dvec3(0) || transmit != dvec3(0); }
};

/// Refers to the material's maps.
TracedMaterial traced_material(const scene::Material& material);
bool is_traced(const scene::Material& material);
bool any_traced(const scene::Scene& scene);

/// The scene without the work of rays [K4, K3.4]. Traced materials lose their reflection maps.
/// Those that transmit also lose their refraction maps, are drawn as opaque ones with d Ka and d
/// Kd, and cast no shadow: light goes through them unbent.
scene::Scene drawn_scene(const scene::Scene& scene);

}  // namespace gw::raytrace
