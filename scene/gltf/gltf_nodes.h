// The nodes of a glTF scene [GLTF2 3.5], each with its place in the world. Does not read what they
// hold.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/scene.h"

#include <vector>

namespace gw::scene {

struct GltfNode {
    std::size_t index = 0;  ///< into `nodes`
    dmat4 world_from_node{1};
};

/// The nodes of the default scene, a parent before its children, in their order. Throws Error for
/// circles and for nodes with two parents.
std::vector<GltfNode> placed_nodes(const GltfDocument& document);

/// Of a matrix, or of translation, rotation and scale.
dmat4 local_matrix(const JsonValue& node);

}  // namespace gw::scene
