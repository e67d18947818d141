// Animations of nodes and of weights of morph targets [GLTF2 3.11] as films. Does not read what they move.
#pragma once

#include "scene/film.h"
#include "scene/gltf/gltf_shape.h"

#include <optional>

namespace gw::scene {

/// The nodes that hold what a scene has: indices into the list of placed_nodes.
struct GltfHolders {
    std::vector<std::size_t> objects, lights;  ///< in the scene's order
    std::vector<dmat4> node_from_object;       ///< of each object
    std::optional<std::size_t> camera;
    std::vector<GltfShaped> shaped;  ///< objects whose vertices move
};

/// One for each animation, in the file's order; none if nothing is animated. The scene is counted
/// from `origin`. Throws Error at the value's place.
std::vector<Film> read_gltf_films(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                                  const GltfHolders& holders, const dvec3& origin);

}  // namespace gw::scene
