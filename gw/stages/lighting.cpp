// I = Ke + model Ka + sum_i att_i spot_i (Ia_i Ka + Id_i Kd cos(theta) + Is_i Ks cos(alpha)^n),
// clamped once.
#include "gw/stages/lighting.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "gw/stages/vertex.h"

#include <cmath>

namespace gw {
namespace {

/// The light that arrives at a point.
struct Incident {
    dvec3 direction{0};   ///< towards the light
    double strength = 1;  ///< attenuation times spot factor
};

/// The denominator of the attenuation is at least this, so that no strength is infinite.
constexpr double least_attenuation = 1e-30;

double spot_factor(const Light& light, const dvec3& to_light) {
    if (light.spot_cos_cutoff <= -1) return 1;
    const double c = dot3(-to_light, normalized(dvec3(light.spot_direction)));
    return c < light.spot_cos_cutoff || c <= 0 ? 0 : pow(c < 1 ? c : 1, light.spot_exponent);
}

Incident incident(const Light& light, const dvec3& p_eye) {
    const dvec3 position(light.position);
    if (light.position.w == 0) return {normalized(position), 1};
    const double w = light.position.w;
    const dvec3 v(position.x / w - p_eye.x, position.y / w - p_eye.y, position.z / w - p_eye.z);
    const double d = length(v);
    const dvec3 direction = normalized(v);
    const double fall = (light.constant_attenuation + light.linear_attenuation * d) +
                        light.quadratic_attenuation * (d * d);
    return {direction,
            spot_factor(light, direction) / (fall > least_attenuation ? fall : least_attenuation)};
}

/// cos(alpha)^n, with alpha between the normal and the half-way vector (GL, IRIS GL).
double highlight(const dvec3& n_eye, const dvec3& to_light, const dvec3& to_eye, double n) {
    const dvec3 half =
        normalized(dvec3(to_light.x + to_eye.x, to_light.y + to_eye.y, to_light.z + to_eye.z));
    const double c = dot3(n_eye, half);
    return pow(c > 0 ? (c < 1 ? c : 1) : 0, n);
}

bool is_black(const vec3& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

/// The strength of a light and its two cosines; 0 for a light behind the surface.
struct Factors {
    double strength = 1, diffuse = 0, specular = 0;
};

Factors factors(const Light& light, const dvec3& p_eye, const dvec3& n_eye, const dvec3& to_eye,
                double exponent, bool gloss) {
    const Incident in = incident(light, p_eye);
    const double cosine = dot3(n_eye, in.direction);
    return {in.strength, cosine > 0 ? cosine : 0,
            cosine > 0 && gloss ? highlight(n_eye, in.direction, to_eye, exponent) : 0};
}

/// What the lights add, highlights apart or not.
struct Sums {
    dvec3 own{0}, highlights{0};
};

void add_light(const Light& light, const Material& m, const dvec3& p_eye, const dvec3& n_eye,
               const dvec3& to_eye, bool separate, Sums& sums) {
    // A black Ks adds exactly 0, so the power is not computed.
    const Factors f = factors(light, p_eye, n_eye, to_eye, m.Ns, !is_black(m.Ks));
    for (int c = 0; c < 3; ++c) {
        const double ambient = double(light.Ia[c]) * m.Ka[c];
        const double lambert = (double(light.Id[c]) * m.Kd[c]) * f.diffuse;
        const double gloss = (double(light.Is[c]) * m.Ks[c]) * f.specular;
        if (separate) {
            sums.own[c] += f.strength * (ambient + lambert);
            sums.highlights[c] += f.strength * gloss;
        } else {
            sums.own[c] += f.strength * ((ambient + lambert) + gloss);
        }
    }
}

}  // namespace

LightTerms light_terms(const Light& light, const dvec3& p_eye, const dvec3& n_eye,
                       const dvec3& to_eye, double exponent, bool gloss) {
    const Factors f = factors(light, p_eye, n_eye, to_eye, exponent, gloss);
    return {f.strength, f.strength * f.diffuse, f.strength * f.specular};
}

LitColors lit_colors(const Material& m, const LightsRef& lights, const LightingState& state,
                     const Profile& profile, const dvec3& p_eye, const dvec3& n_eye) {
    const dvec3 to_eye = state.local_viewer ? normalized(-p_eye) : dvec3(0, 0, 1);
    Sums sums;
    for (int c = 0; c < 3; ++c) sums.own[c] = m.Ke[c] + double(state.model_ambient[c]) * m.Ka[c];
    if (lights)
        for (const Light& light : *lights)
            add_light(light, m, p_eye, n_eye, to_eye, state.separate_specular, sums);

    const auto store = [&](double v) {
        return double(rescale(quantize(v, profile.lit_bits), profile.lit_bits, profile.color_bits));
    };
    const auto& [own, highlights] = sums;
    return {{store(own.x), store(own.y), store(own.z), store(m.alpha)},
            {store(highlights.x), store(highlights.y), store(highlights.z), 0}};
}

}  // namespace gw
