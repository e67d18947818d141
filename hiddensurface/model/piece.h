// Pieces of polygons made by splitting, and whether two overlap in the window. A cut is never
// snapped: it is a line that divides pixel centres. So each pixel of a polygon belongs to exactly
// one of its pieces. Does not choose cuts.
#pragma once

#include "hiddensurface/model/polygon.h"

#include <utility>

namespace gw::hiddensurface {

/// Pixels whose centre (x, y) on the grid has line.x x + line.y y + line.z < 0, or >= 0 if
/// `!negative`.
struct PixelCut {
    dvec3 line{0};
    bool negative = true;
};

/// A part of consecutive triangles of a polygon.
struct Piece {
    std::size_t polygon = 0;           ///< index
    std::size_t first = 0, count = 0;  ///< of the polygon's triangles
    std::string name;                  ///< in step logs
    /// convex, on the window grid: for deciding, not for drawing
    std::vector<Loop> parts;
    std::vector<PixelCut> cuts;
};

/// All of polygon number `index`.
Piece whole(std::size_t index, const Polygon& polygon);

/// The line in the window in which the plane `by` crosses the piece's plane; negative before `by`.
dvec3 cut_line(const dvec4& piece, const dvec4& by);

/// Parts of convex loops with side(plane) <= 0, and those with >= 0.
std::pair<std::vector<Loop>, std::vector<Loop>> divide(const std::vector<Loop>& parts,
                                                       const dvec4& plane);

/// A side in the window.
using CutEdge = std::pair<dvec2, dvec2>;
/// The piece's sides that cuts made.
std::vector<CutEdge> edges_made(const Piece& piece);

/// A piece's pixels, by scan conversion of its polygon's triangles [L7].
std::vector<Run> runs_of(const Piece& piece, const Polygon& polygon, int subpixel_bits,
                         const Rect& window);

/// Least and greatest coordinate of a piece along x, y or z.
std::pair<double, double> extent(const Piece& piece, int axis);

/// Neighbours made by a cut may overlap by the rounding of its ends: less than this, in grid units.
constexpr double border = 0x1p-20;

/// The intervals share more than a border.
inline bool overlap(const std::pair<double, double>& a, const std::pair<double, double>& b) {
    return a.first + border < b.second && b.first + border < a.second;
}

/// A part of a and a part of b share more than a border: no side of either separates them. Does not
/// compare depths.
bool projections_overlap(const Piece& a, const Piece& b);

}  // namespace gw::hiddensurface
