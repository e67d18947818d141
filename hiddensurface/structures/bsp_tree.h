// A binary space partition of a scene's polygons [L5]: built in the world before any eye is known,
// then walked far to near for any eye. Does not project or draw.
#pragma once

#include "hiddensurface/model/polygon.h"

#include <functional>

namespace gw::hiddensurface {

/// A facet of a polygon in the world, by index.
struct FacetIndex {
    std::size_t polygon = 0, facet = 0;
};

/// The piece of a facet that the planes above its node leave: convex parts in the world, and the
/// planes that cut it. A cut has the facet of the plane, and whether this piece is on the side of
/// its normal.
struct TreePiece {
    FacetIndex of;
    std::vector<Loop> parts;
    std::vector<std::pair<FacetIndex, bool>> cuts;
};

/// False: its corners are on one line, or its parts cancel.
bool has_area(const WorldFacet& facet);
/// The plane of a facet in the world, its normal of length 1. Without area: one that its
/// corners are in.
dvec4 unit_plane(const WorldFacet& facet);
/// Points nearer than this to a plane are on it. Positions are float32, so corners of one plane may
/// be off by this part of the scene's size.
double world_tolerance(const std::vector<Polygon>& polygons);

/// Where a piece is: in a plane, on one side of it, or across.
enum class PlaneSide { On, Front, Back, Both };
PlaneSide side_of(const TreePiece& piece, const dvec4& plane, double tolerance);
/// Cuts a piece by the plane of facet `by`: the part behind it and the part in front.
std::pair<TreePiece, TreePiece> cut_piece(const TreePiece& piece, FacetIndex by,
                                          const dvec4& plane);
/// All facets of the polygons, in this order.
std::vector<TreePiece> pieces_of(const std::vector<Polygon>& polygons,
                                 const std::vector<std::size_t>& order);

inline constexpr std::size_t no_node = std::size_t(-1);

struct TreeNode {
    dvec4 plane{0, 0, 0, 0};                      ///< of the first piece; the normal's length is 1
    std::vector<TreePiece> pieces;                ///< in the plane
    std::size_t front = no_node, back = no_node;  ///< indices into Tree::nodes
};

/// A tree may be as deep as it has nodes: a convex solid's is one chain. So the nodes are a list, and
/// no function here is recursive.
struct Tree {
    std::vector<TreeNode> nodes;  ///< the root first
    std::uint64_t pieces = 0, splits = 0;
    std::uint64_t plane_tests = 0;  ///< polygons compared with planes
};

/// The signed distance of each of the piece's corners to a plane of length 1; 0 if it may be all
/// rounding.
std::vector<double> distances_of(const TreePiece& piece, const dvec4& plane);

/// Called for each split: the piece, the piece whose plane cuts it, its parts on the back and front
/// side.
using SplitSink = std::function<void(const TreePiece&, const TreePiece& by, const TreePiece& back,
                                     const TreePiece& front)>;

/// A node as it is made: its place, and the number of pieces left for each side.
struct NewNode {
    const Tree& tree;  ///< so far
    const TreeNode& node;
    std::size_t number = 0, parent = no_node;
    bool in_front = false;  ///< of the parent
    std::size_t front = 0, back = 0;
};
using NodeSink = std::function<void(const NewNode&)>;
struct TreeSinks {
    SplitSink on_split;
    NodeSink on_node;
};
/// Called for each node of the walk: the eye's distance to the plane, above 0 in front.
using EyeSink = std::function<void(std::size_t node, double distance)>;

/// The number of splitters that the algorithms try at a node.
inline constexpr std::size_t splitters_tried = 8;

/// `order`: indices of polygons. Every node's plane is that of the piece that cuts fewest others, of
/// `candidates` pieces spread evenly over the remaining ones (1: always the first).
Tree build_tree(const std::vector<Polygon>& polygons, const std::vector<std::size_t>& order,
                std::size_t candidates = 1, const TreeSinks& sinks = {});

/// Visits every piece once, always after the pieces that it may hide. `eye`: (P_E, 1), or (direction
/// towards it, 0). Returns the number of planes compared with the eye.
std::uint64_t far_to_near(const Tree& tree, const dvec4& eye,
                          const std::function<void(const TreePiece&)>& visit,
                          const EyeSink& on_eye = {});

}  // namespace gw::hiddensurface
