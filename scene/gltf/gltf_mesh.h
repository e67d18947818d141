// Primitives of meshes [GLTF2 3.7.2] as vertices, colours, morph targets and influences of joints. Does
// not place them.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_material.h"
#include "scene/gltf/gltf_shape.h"

namespace gw::scene {

/// The primitive, without positions if it has too few corners, with the texture coordinates of these
/// sets, t upwards. `name` is the object's in warnings. Throws Error at the value's place.
GltfMesh read_primitive(const GltfDocument& document, const JsonValue& primitive,
                        const CoordinateSet& own, const std::optional<CoordinateSet>& other,
                        const std::string& name);

/// The numbers that its accessors promise; they are not read.
std::size_t numbers_of_primitive(const GltfDocument& document, const JsonValue& primitive);

}  // namespace gw::scene
