// A binary space partition of a scene's polygons [L5]: built in the world before any eye is known,
// walked far to near for any eye after. Does not project or draw.
#pragma once

#include "hiddensurface/model/polygon.h"

#include <functional>

namespace gw::hiddensurface {

/// A facet of a polygon in the world, by index.
struct FacetIndex {
    std::size_t polygon = 0, facet = 0;
};

/// What is left of a facet after the planes above its node: convex parts in the world, and which
/// planes cut it (the facet whose plane it is; whether this piece is on the side its normal points
/// to).
struct TreePiece {
    FacetIndex of;
    std::vector<Loop> parts;
    std::vector<std::pair<FacetIndex, bool>> cuts;
};

/// The plane of a facet in the world, its normal of length 1; 0 where the facet has no area.
dvec4 unit_plane(const WorldFacet& facet);
/// Points nearer than this to a plane are on it: positions are float32, so corners of one plane lie
/// this near to it, by the size of the scene.
double world_tolerance(const std::vector<Polygon>& polygons);

/// Where a piece lies: in a plane, on one side of it, or across.
enum class Place { On, Front, Back, Both };
Place place_of(const TreePiece& piece, const dvec4& plane, double tolerance);
/// Cuts a piece by the plane of facet `by`: what is behind it and what is in front.
std::pair<TreePiece, TreePiece> cut_piece(const TreePiece& piece, FacetIndex by,
                                          const dvec4& plane);
/// All facets that have an area, of the polygons in this order.
std::vector<TreePiece> pieces_of(const std::vector<Polygon>& polygons,
                                 const std::vector<std::size_t>& order);

inline constexpr std::size_t no_node = std::size_t(-1);

struct TreeNode {
    dvec4 plane{0, 0, 0, 0};                      ///< of the first piece; the normal's length is 1
    std::vector<TreePiece> pieces;                ///< in the plane
    std::size_t front = no_node, back = no_node;  ///< indices into Tree::nodes
};

/// A tree may be as deep as it has nodes: a convex solid's is one chain. So the nodes are a list,
/// and nothing here calls itself.
struct Tree {
    std::vector<TreeNode> nodes;  ///< the root first
    std::uint64_t pieces = 0, splits = 0;
    std::uint64_t plane_tests = 0;  ///< polygons compared with planes
};

/// Called for each split: the piece, the facet whose plane cuts it, its parts on the back and front
/// side.
using SplitSink = std::function<void(const TreePiece&, FacetIndex by, const std::vector<Loop>&,
                                     const std::vector<Loop>&)>;

/// How many splitters the algorithms try at a node.
inline constexpr std::size_t splitters_tried = 8;

/// `order`: indices of polygons. At every node the plane is that of the piece which cuts fewest
/// others among the first `candidates` of those left (1: always the first).
Tree build_tree(const std::vector<Polygon>& polygons, const std::vector<std::size_t>& order,
                std::size_t candidates = 1, const SplitSink& on_split = {});

/// Visits every piece once, none before one that it may hide. `eye`: (P_E, 1), or (direction
/// towards it, 0). Returns the number of planes compared with the eye.
std::uint64_t far_to_near(const Tree& tree, const dvec4& eye,
                          const std::function<void(const TreePiece&)>& visit);

}  // namespace gw::hiddensurface
