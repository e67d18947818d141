#include "scene/maps/physical.h"

#include "gw/base/elementary.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

double encoded_number(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

double decoded_number(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : pow((shown + 0.055) / 1.055, 2.4);
}

}  // namespace

double metallic_of(const dvec3& F0) { return std::max({F0.x, F0.y, F0.z}); }

double Physical::metallic_part() const { return F0 ? metallic_of(*F0) : metallic; }

dvec3 Physical::F0_of_all() const {
    const dvec3 of_dielectric = glm::min(F0_tint * (dielectric_F0 * specular), dvec3(1));
    return F0.value_or(glm::mix(of_dielectric, base, metallic));
}

Reflection reflection_of(const Physical& p) {
    const double metallic = p.metallic_part();
    const dvec3 F0 = p.F0_of_all(), diffuse = p.base * (1 - metallic);
    const Highlight highlight = highlight_of(F0, diffuse, p.roughness);
    return {.diffuse = encoded(diffuse),
            .highlight = highlight.Ks,
            .Ka = encoded(glm::min(diffuse + F0, dvec3(1))),
            .Ns = highlight.Ns,
            .broad = float(metallic * p.roughness / 2)};
}

void set_words(const Physical& p, Material& material) {
    material.is_encoded = true;
    if (p.unlit) {
        material.Ka = material.Kd = material.Ks = vec3(0);
        material.Ke = encoded(p.base);
        return;
    }
    const Reflection reflection = reflection_of(p);
    material.Ka = reflection.Ka;
    material.Kd = reflection.Kd();
    material.Ks = reflection.Ks();
    material.Ns = reflection.Ns;
    material.Ke = encoded(p.emissive);
}

vec3 encoded(const dvec3& linear) {
    return {float(encoded_number(linear.x)), float(encoded_number(linear.y)),
            float(encoded_number(linear.z))};
}

dvec3 decoded(const dvec3& shown) {
    return {decoded_number(shown.x), decoded_number(shown.y), decoded_number(shown.z)};
}

namespace {

/// roughness^4, for which a highlight is at least seen.
double squared_alpha(double roughness) {
    constexpr double sharpest = 0.01;
    return std::max(roughness * roughness * roughness * roughness, sharpest * sharpest);
}

}  // namespace

dvec3 lit_at_peak(const dvec3& F0, const dvec3& diffuse, double roughness) {
    const dvec3 lit = diffuse + F0 / (4 * squared_alpha(roughness));
    return glm::max(lit / std::max({lit.x, lit.y, lit.z, 1.0}), diffuse);
}

Highlight highlight_of(const dvec3& F0, const dvec3& diffuse, double roughness) {
    constexpr double most_Ns = 10000, least_seen = 1e-6;
    const double a2 = squared_alpha(roughness);
    const dvec3 peak = F0 / (4 * a2);
    Highlight out{encoded(lit_at_peak(F0, diffuse, roughness)) - encoded(diffuse), 0};

    // Where the strongest channel has half its height on the display: GGX is (a2 / root)^2 there.
    const int k = peak.x >= peak.y && peak.x >= peak.z ? 0 : peak.y >= peak.z ? 1 : 2;
    if (double(out.Ks[k]) < least_seen) return {};  // its width would be one of rounding errors
    const double half =
        decoded_number(encoded_number(diffuse[k]) + double(out.Ks[k]) / 2) - diffuse[k];
    const double root = std::sqrt(half / peak[k]);
    const double cos2 = (1 - a2 / root) / (1 - a2);
    if (a2 < 1 && root > a2) out.Ns = float(std::min(log(0.25) / log(cos2), most_Ns));
    return out;
}

}  // namespace gw::scene
