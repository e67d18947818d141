// Materials of glTF in MTL's words. docs/scenes.md, "glTF", has the rule. Does not read textures.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/maps/physical.h"
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

/// Texture coordinates of a mesh.
struct CoordinateSet {
    std::size_t index = 0;
    std::optional<TextureTransform> turn;  ///< if the maps are turned
};

struct GltfMaterial {
    Material material;
    CoordinateSet own;  ///< of its first map
    /// of others; those are Map::is_mean until the mesh has patches
    std::optional<CoordinateSet> other;
    dvec3 luminance{0};  ///< that it emits, linear, in nit
    bool double_sided = false;
};

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

}  // namespace gw::scene
