// Physically based surfaces [GLTF2 3.9] in MTL's words. docs/scenes.md, "glTF", has the rule. Does not
// read textures.
#pragma once

#include "scene/scene.h"

namespace gw::scene {

/// F0 of a dielectric of index 1.5.
inline constexpr double dielectric_F0 = 0.04;

/// What a material is before it has MTL's words.
struct Physical {
    dvec3 base{1}, emissive{0}, F0_tint{1};
    std::optional<dvec3> F0;  ///< instead of what base, tint, metallic and specular make
    double alpha = 1, metallic = 1, roughness = 1, specular = 1;
    bool unlit = false;

    /// 1 - m of the base scatters. A surface with F0 of its own scatters what F0 leaves.
    double metallic_part() const;
    /// What it reflects of the light along its normal, without what it scatters.
    dvec3 F0_of_all() const;
};
/// The metallic part of a surface with F0 of its own: the largest channel.
double metallic_of(const dvec3& F0);

/// What of a surface does not depend on maps, encoded.
struct Reflection {
    vec3 diffuse{0}, highlight{0};
    vec3 Ka{0};  ///< of light from all sides: what it scatters, and F0
    float Ns = 0;
    /// The share of a metal's highlight that Kd has: GGX is broader than Ns alone can be.
    float broad = 0;

    vec3 Kd() const { return diffuse + highlight * broad; }
    vec3 Ks() const { return highlight * (1 - broad); }
};
Reflection reflection_of(const Physical& p);
/// The words of such a material.
void set_words(const Physical& p, Material& material);

/// An intensity or reflectance that is proportional to light, as the frame buffer shows it: encoded as
/// in sRGB, and beyond 1 by the same formula.
vec3 encoded(const dvec3& linear);
/// Its reverse.
dvec3 decoded(const dvec3& shown);

/// What light a surface shows at the peak of its highlight, on white: F0 / (4 roughness^4) high beside
/// the diffuse part. Beyond white it keeps its hue.
dvec3 lit_at_peak(const dvec3& F0, const dvec3& diffuse, double roughness);

/// Ks and Ns of the lobe that looks, on a display and beside the diffuse part, as high and at half of
/// its height as wide as GGX seen along the normal.
struct Highlight {
    vec3 Ks{0};
    float Ns = 0;
};
Highlight highlight_of(const dvec3& F0, const dvec3& diffuse, double roughness);

}  // namespace gw::scene
