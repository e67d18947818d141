// Pieces of polygons made by splitting. A cut is never snapped: it is a line that divides pixel
// centres, so that the pieces of a polygon have every one of its pixels exactly once. Does not
// choose where to cut.
#pragma once

#include "hiddensurface/model/polygon.h"

#include <optional>
#include <utility>

namespace gw::hiddensurface {

/// Pixels whose centre (x, y) on the grid has a.x x + a.y y + a.z < 0 (or not, where `!negative`).
struct PixelCut {
    dvec3 line{0};
    bool negative = true;
};

/// What is left of consecutive triangles of a polygon.
struct Piece {
    std::size_t polygon = 0;           ///< index
    std::size_t first = 0, count = 0;  ///< of the polygon's triangles
    /// convex, on the window grid: for deciding, not for drawing
    std::vector<Loop> parts;
    std::vector<PixelCut> cuts;
};

/// All of polygon number `index`.
Piece whole(std::size_t index, const Polygon& polygon);
/// One facet of it.
Piece whole(std::size_t index, const Facet& facet);

/// Where the plane `by` crosses the piece's plane, seen in the window: negative before `by`.
dvec3 cut_line(const dvec4& piece, const dvec4& by);

/// How far the piece lies before and behind a plane: least and greatest side of its corners.
std::pair<double, double> sides(const Piece& piece, const dvec4& plane);

/// Parts of convex loops with side(plane) <= 0, and those with >= 0.
std::pair<std::vector<Loop>, std::vector<Loop>> divide(const std::vector<Loop>& parts,
                                                       const dvec4& plane);

/// The piece, of facet `of`, before the plane of `by` and the piece behind it; none where it does
/// not reach farther than the tolerance on both sides.
std::optional<std::pair<Piece, Piece>> split(const Piece& piece, const Facet& of, const Facet& by);

/// A side in the window.
using CutEdge = std::pair<dvec2, dvec2>;
/// The piece's sides that cuts made.
std::vector<CutEdge> edges_made(const Piece& piece);

/// The pixels of a piece, by scan conversion of its polygon's triangles [L7].
std::vector<Run> runs_of(const Piece& piece, const Polygon& polygon, int subpixel_bits,
                         const Rect& window);

}  // namespace gw::hiddensurface
