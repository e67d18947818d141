// Takes pieces of polygons that were cut in the world to the window grid. A cut is drawn as a line
// between pixels, so every polygon keeps its pixels. Does not build trees.
#pragma once

#include "hiddensurface/run/algorithm.h"
#include "hiddensurface/structures/bsp_tree.h"

namespace gw::hiddensurface {

inline const WorldFacet& facet_of(const Input& input, FacetIndex i) {
    return input.polygons[i.polygon].world_facets[i.facet];
}

/// The piece on the grid; it has no triangles if the facet is outside the window.
Piece window_piece(const Input& input, const TreePiece& piece);

/// Logs a Split step: the piece, the facet whose plane cuts it, its parts behind and before that
/// plane.
void log_split(const Input& input, const TreePiece& piece, FacetIndex by,
               const std::vector<Loop>& back, const std::vector<Loop>& front, StepLog& log);

}  // namespace gw::hiddensurface
