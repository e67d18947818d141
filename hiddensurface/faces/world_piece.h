// Takes pieces of polygons that were cut in the world to the window grid. A cut is drawn as a line
// between pixels, so every polygon keeps its pixels. Does not build trees.
#pragma once

#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/structures/bsp_tree.h"

namespace gw::hiddensurface {

inline const WorldFacet& facet_of(const Input& input, FacetIndex i) {
    return input.polygons[i.polygon].world_facets[i.facet];
}

/// The piece on the grid; it has no triangles if the facet is outside the window.
Piece window_piece(const Input& input, const TreePiece& piece);

/// The piece's name in step logs: its facet's, with a letter for each cut: "a" for the part on the
/// side of the plane's normal, "b" for the other.
std::string name_of(const std::vector<Polygon>& polygons, const TreePiece& piece);

/// Logs a Split step: the piece, the piece whose plane cuts it, its parts behind and in front; its
/// corners' distances, above 0 on the side of the plane's normal.
void log_split(const Input& input, const TreePiece& piece, const TreePiece& by,
               const TreePiece& back, const TreePiece& front, StepLog& log);

/// Logs of a tree's parts as they are made, with its counts so far, and of the eye's side at each
/// node of the walk.
TreeSinks tree_log(const Input& input, Counts& counts, StepLog& log);
EyeSink eye_log(const Input& input, StepLog& log);

}  // namespace gw::hiddensurface
