#include "raytrace/tracer/traced_material.h"

#include <algorithm>

namespace gw::raytrace {
namespace {

const std::vector<scene::Map>* unless_empty(const std::vector<scene::Map>& maps) {
    return maps.empty() ? nullptr : &maps;
}

}  // namespace

TracedMaterial traced_material(const scene::Material& m) {
    TracedMaterial t;
    if (m.illum < 3 || m.illum > 7) return t;
    t.fresnel = m.illum == 5 || m.illum == 7;
    t.reflect = dvec3(m.Ks);
    t.transmit = (1 - double(m.d)) * dvec3(m.Tf);
    t.Ni = double(m.Ni);
    t.reflection_far = unless_empty(m.refl);
    t.refraction_far = m.refraction.empty() ? unless_empty(m.refl) : &m.refraction;
    return t;
}

bool is_traced(const scene::Material& material) { return traced_material(material).any(); }

bool any_traced(const scene::Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const scene::Object& o) {
        return is_traced(scene.materials[o.material]);
    });
}

scene::Scene drawn_scene(const scene::Scene& scene) {
    scene::Scene drawn = scene;
    for (scene::Object& object : drawn.objects) {
        const TracedMaterial traced = traced_material(scene.materials[object.material]);
        if (traced.transmit != dvec3(0)) object.casts_shadow = false;
    }
    for (scene::Material& m : drawn.materials) {
        const TracedMaterial traced = traced_material(m);
        if (!traced.any()) continue;
        m.refl.clear();
        if (traced.transmit == dvec3(0)) continue;
        m.refraction.clear();
        m.Ka *= m.d;
        m.Kd *= m.d;
        m.d = 1;
    }
    return drawn;
}

}  // namespace gw::raytrace
