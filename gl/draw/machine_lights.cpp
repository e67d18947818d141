// Lights and materials in the machine's words.
#include "gl/draw/machine_state.h"

#include "gw/base/elementary.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace gw::gl {

namespace {

vec3 rgb(const vec4& c) { return {c.x, c.y, c.z}; }

/// cos of an angle in degrees, 0 .. 90 or 180.
float cutoff_cosine(float degrees) {
    return degrees == 180 ? -1.0f : float(cos_degrees(double(degrees)));
}

/// [GL11] 2.13.1: the spot factor of a directional light, the same at every vertex. The machine's
/// directional lights have none, so it is a factor of their colours.
float directional_spot(const LightState& s) {
    if (s.position.w != 0 || s.spot_cutoff == 180) return 1;
    const double c = -dot3(normalized(dvec3(s.position)), normalized(dvec3(s.spot_direction)));
    if (c < double(cutoff_cosine(s.spot_cutoff)) || c <= 0) return 0;
    return float(gw::pow(std::min(c, 1.0), double(s.spot_exponent)));
}

}  // namespace

LightsRef machine_lights(const LightingState& lighting) {
    if (!lighting.enable) return nullptr;
    auto lights = std::make_shared<std::vector<gw::Light>>();
    for (const LightState& s : lighting.lights) {
        if (!s.enable) continue;
        const float spot = directional_spot(s);
        lights->push_back({.position = s.position,
                           .Ia = spot * rgb(s.ambient),
                           .Id = spot * rgb(s.diffuse),
                           .Is = spot * rgb(s.specular),
                           .spot_direction = s.spot_direction,
                           .spot_exponent = s.spot_exponent,
                           .spot_cos_cutoff = cutoff_cosine(s.spot_cutoff),
                           .constant_attenuation = s.constant_attenuation,
                           .linear_attenuation = s.linear_attenuation,
                           .quadratic_attenuation = s.quadratic_attenuation});
    }
    return lights->empty() ? nullptr : lights;
}

gw::Material machine_material(const MaterialState& m) {
    return {.Ka = rgb(m.ambient),
            .Kd = rgb(m.diffuse),
            .Ks = rgb(m.specular),
            .Ke = rgb(m.emission),
            .Ns = m.shininess,
            .alpha = m.diffuse.w};
}

}  // namespace gw::gl
