// Schumacker's clusters: a scene divided by planes into clusters of faces, each with priorities
// that hold for every eye. Built in the world before any eye is known. Does not project or draw.
#pragma once

#include "hiddensurface/structures/bsp_tree.h"

namespace gw::hiddensurface {

/// One side of a face, and its priority in the cluster: for no eye does it hide a side of a smaller
/// number.
struct RankedSide {
    std::size_t piece = 0;
    bool front = true;
    std::size_t priority = 1;
};

/// A separating plane with what is on both sides, or a cluster.
struct ClusterNode {
    dvec4 plane{0, 0, 0, 0};                      ///< of length 1; of a cluster 0
    std::size_t front = no_node, back = no_node;  ///< indices into ClusterTree::nodes
    std::vector<TreePiece> pieces;
    /// greatest number first; of one number the scene's first last
    std::vector<RankedSide> sides;
};

/// As deep as it has planes where faces are peeled off one by one: a list, as Tree.
struct ClusterTree {
    std::vector<ClusterNode> nodes;  ///< the root first
    std::uint64_t clusters = 0, separations = 0, pieces = 0, splits = 0, plane_tests = 0;
    std::uint64_t comparison_bytes = 0;  ///< peak memory of a cluster's faces against each other
    std::uint64_t cyclic = 0;  ///< clusters that have no priorities and that no plane divides
};

/// Faces are cut only where no plane of a face or between them separates without.
ClusterTree build_clusters(const std::vector<Polygon>& polygons, const SplitSink& on_split);

/// The sides that the eye sees, every one before those that may hide it. Returns the signs asked.
std::uint64_t far_to_near(const ClusterTree& tree, const std::vector<Polygon>& polygons,
                          const dvec4& eye,
                          const std::function<void(const TreePiece&, const RankedSide&)>& visit);

}  // namespace gw::hiddensurface
