// Regions of the window with straight sides, and Weiler and Atherton's clipping of a region by a
// convex contour. A corner is the point in which two lines meet. Every question about sides and
// order is the sign of a determinant of three lines, in integers. If it is 0, the lines count as
// moved outwards by amounts too small to matter, smaller for each next line. So no corner ever lies
// on a line, and no side on another. Does not know depth.
#pragma once

#include "hiddensurface/faces/face.h"

namespace gw::hiddensurface {

/// a x + b y + c > 0 inside, x and y on the grid; a and b below 2^31, c below 2^54.
struct LineEquation {
    std::int64_t a = 0, b = 0, c = 0;
};

/// Sides in order, as indices of lines. Sides k and k + 1 meet in corner k. The inside is to the
/// left.
using Contour = std::vector<std::size_t>;
/// Any number of parts, with holes.
using Region = std::vector<Contour>;

class Lines {
public:
    std::size_t add(const LineEquation& line);
    Contour add_contour(const std::vector<GridPoint>& counter_clockwise);
    /// A triangle on the side of `line` > 0, large enough for all windows.
    Contour add_half_plane(const LineEquation& line);

    dvec2 corner(std::size_t i, std::size_t j) const;
    std::vector<dvec2> corners(const Contour& contour) const;
    /// Sign of line k at the corner of i and j; 0 only if k is one of them.
    int side(std::size_t i, std::size_t j, std::size_t k) const;
    /// True if a line of `clip`, not moved, has all corners of the region on it or outside.
    bool separates(const Contour& clip, const Region& region) const;

    /// The parts of the region inside and outside the convex `clip`. No line of `clip` may bound the
    /// region.
    std::pair<Region, Region> clip(const Region& region, const Contour& clip) const;

    /// The region's pixels, as in scan conversion: left and top sides belong to it, right and bottom
    /// sides do not.
    std::vector<Run> runs(const Region& region, int subpixel_bits, const Rect& window) const;

private:
    int128 determinant(std::size_t i, std::size_t j, std::size_t k) const;
    std::int64_t cross(std::size_t i, std::size_t j) const;
    /// All corners are on one line: no pixel's centre is inside.
    bool is_flat(const Contour& contour) const;
    bool is_inside(std::size_t i, std::size_t j, const Region& region) const;

    friend class Clipper;
    std::vector<LineEquation> lines_;
};

}  // namespace gw::hiddensurface
