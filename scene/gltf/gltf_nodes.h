// The nodes of a glTF scene [GLTF2 3.5], each with its place in the world, and the skins whose joints
// are nodes [GLTF2 3.7.3]. Does not read what else they hold.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace gw::scene {

/// A node's place in its parent.
struct GltfPlace {
    dmat4 matrix{1};  ///< instead of the others, or 1
    dvec3 translation{0};
    dvec4 rotation{0, 0, 0, 1};  ///< x, y, z, w, of length 1
    dvec3 scale{1};

    dmat4 parent_from_node() const;
};

struct GltfNode {
    static constexpr std::size_t no_parent = std::size_t(-1);
    std::size_t index = 0;           ///< into `nodes`
    std::size_t parent = no_parent;  ///< into the list that placed_nodes returns
    GltfPlace place;
    dmat4 world_from_node{1};
};

/// The nodes of the default scene, a parent before its children, in their order. Throws Error for
/// circles and for nodes with two parents.
std::vector<GltfNode> placed_nodes(const GltfDocument& document);

/// The place in the list of placed_nodes of each of the file's nodes; GltfNode::no_parent: it is not in
/// the scene.
std::vector<std::size_t> places_of(const GltfDocument& document,
                                   const std::vector<GltfNode>& nodes);

/// The places in a node of the instances of its mesh (EXT_mesh_gpu_instancing); of a node without
/// the extension one, its own. Throws Error if there are more than `most`.
std::vector<dmat4> instances_of(const GltfDocument& document, const JsonValue& node,
                                std::size_t most);

struct GltfSkin {
    std::vector<std::size_t> joints;     ///< into the list of placed_nodes
    std::vector<dmat4> joint_from_rest;  ///< of each joint
};

/// The skin that a node names. Throws Error if a joint is not in the scene.
GltfSkin read_gltf_skin(const GltfDocument& document, const JsonValue& index,
                        const std::vector<std::size_t>& places);

/// The matrix of an object at such a place, which may not be singular. Flat objects keep a millionth of
/// their size across (geometry/transform.h); those scaled to a line or a point keep 1e-9 of all.
dmat4 drawable(const dmat4& world_from_object);

/// Gives all nodes their places in the world by their places in their parents.
void place_in_world(std::vector<GltfNode>& nodes);

}  // namespace gw::scene
