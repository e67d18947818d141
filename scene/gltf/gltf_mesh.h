// Primitives of meshes [GLTF2 3.7.2] as the machine's meshes. Does not place them and does not know
// materials.
#pragma once

#include "gw/mesh.h"
#include "scene/gltf/gltf_document.h"

#include <optional>

namespace gw::scene {

struct GltfMesh {
    MeshData mesh;  ///< without polygon_ids and colours
    /// of the vertex colours; none: there are none
    std::optional<vec4> mean_color;
    bool colors_vary = false;
};

/// The primitive, without positions if it has too few corners, with the texture coordinates of set `texcoord_set`, t upwards. Faces without normals
/// are flat [GLTF2 3.7.2.1]. `name` is the object's in warnings. Throws Error at the value's place.
GltfMesh read_primitive(const GltfDocument& document, const JsonValue& primitive,
                        std::size_t texcoord_set, const std::string& name);

}  // namespace gw::scene
