// Schumacker's clusters: planes divide a scene into clusters of faces with priorities that hold for
// every eye. Built in the world before any eye is known. Does not project or draw.
#pragma once

#include "hiddensurface/structures/bsp_tree.h"

namespace gw::hiddensurface {

/// One side of a face, and its priority in the cluster. For no eye does it hide a side of a smaller
/// number.
struct RankedSide {
    std::size_t piece = 0;
    bool front = true;
    std::size_t priority = 1;
};

/// A separating plane with the nodes on both sides, or a cluster.
struct ClusterNode {
    dvec4 plane{0, 0, 0, 0};                      ///< of length 1; of a cluster 0
    std::size_t front = no_node, back = no_node;  ///< indices into ClusterTree::nodes
    std::vector<TreePiece> pieces;
    std::vector<RankedSide> sides;  ///< greatest number first; of equal ones the scene's first last
};

/// A tree may be as deep as it has planes, so its nodes are a list, as in Tree.
struct ClusterTree {
    std::vector<ClusterNode> nodes;  ///< the root first
    std::uint64_t clusters = 0, separations = 0, pieces = 0, splits = 0, plane_tests = 0;
    std::uint64_t comparison_bytes = 0;  ///< peak memory of comparing a cluster's faces
};

/// A face is cut only if no plane separates the faces without a cut.
ClusterTree build_clusters(const std::vector<Polygon>& polygons, const SplitSink& on_split);

/// Visits the sides that the eye sees, each before those that may hide it. Returns the number of
/// signs of D_f.
std::uint64_t far_to_near(const ClusterTree& tree, const std::vector<Polygon>& polygons,
                          const dvec4& eye,
                          const std::function<void(const TreePiece&, const RankedSide&)>& visit,
                          const EyeSink& on_eye = {});

}  // namespace gw::hiddensurface
