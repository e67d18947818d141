// Materials of glTF in MTL's words. docs/scenes.md, "glTF", has the rule. Does not read textures.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/scene.h"

#include <optional>

namespace gw::scene {

/// KHR_texture_transform, with v downwards: scaled, then turned about 0, then moved.
struct TextureTransform {
    dvec2 scale{1}, offset{0};
    double rotation = 0;  ///< radians
    bool operator==(const TextureTransform&) const = default;

    vec2 moved(const vec2& st) const;  ///< t upwards
};

struct GltfMaterial {
    Material material;
    std::size_t texcoord_set = 0;  ///< of its maps
    dvec3 luminance{0};            ///< that it emits, linear, in nit
    /// of the texture coordinates of meshes, if its maps are turned
    std::optional<TextureTransform> turn;
};

/// An intensity or reflectance that is proportional to light, as the frame buffer shows it: encoded as
/// in sRGB, and beyond 1 by the same formula.
vec3 encoded(const dvec3& linear);

/// What vertex colours make of a material.
struct Tint {
    vec4 color{1};       ///< its colour and opacity are multiplied by it
    TextureRef texture;  ///< a map of its colour; null: none
};

/// The material of a value of `materials`. Warns of what is left out. Throws Error at the value's
/// place. A tint's texture is for materials that have none.
GltfMaterial read_gltf_material(const GltfDocument& document, const JsonValue& material,
                                const std::string& name, const Tint& tint);

/// The material of primitives without one [GLTF2 3.9.1].
GltfMaterial default_gltf_material(const Tint& tint);

/// Ks and Ns of the lobe that looks, on a display and beside the diffuse part, as high and at half of
/// its height as wide as GGX seen along the normal: F0 / (4 a2) high, where a2 = roughness^4.
struct Highlight {
    vec3 Ks{0};
    float Ns = 0;
};
Highlight highlight_of(const dvec3& F0, const dvec3& diffuse, double roughness);

}  // namespace gw::scene
