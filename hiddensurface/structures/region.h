// Regions of the window with straight sides, and Weiler and Atherton's clipping of one by a convex
// other. A corner is where two lines meet, and every question (which side, which first) is the sign
// of a determinant of three lines, in integers. Where that is 0, the lines are taken as moved
// outwards by amounts too small to matter, smaller for every next line: no corner ever lies on a
// line, and no two sides on each other. Does not know depth.
#pragma once

#include "hiddensurface/model/face.h"

namespace gw::hiddensurface {

/// a x + b y + c > 0 inside, x and y on the grid; a and b below 2^31, c below 2^54.
struct LineEquation {
    std::int64_t a = 0, b = 0, c = 0;
};

/// Sides in order, as indices of lines; corner k is where sides k and k + 1 meet. Inside is to the
/// left.
using Contour = std::vector<std::size_t>;
/// Any number of parts, with holes.
using Region = std::vector<Contour>;

class Lines {
public:
    std::size_t add(const LineEquation& line);
    Contour add_contour(const std::vector<GridPoint>& counter_clockwise);
    /// So much of the side where `line` > 0 that all windows are in it.
    Contour add_half_plane(const LineEquation& line);

    dvec2 corner(std::size_t i, std::size_t j) const;
    std::vector<dvec2> corners(const Contour& contour) const;
    /// Sign of line k at the corner of i and j; 0 only where k is one of them.
    int side(std::size_t i, std::size_t j, std::size_t k) const;
    /// Some line of `clip` has all corners of the region on it or outside, before any is moved.
    bool separates(const Contour& clip, const Region& region) const;

    /// What of the region is inside the convex `clip`, none of whose lines bounds the region, and
    /// what is outside.
    std::pair<Region, Region> clip(const Region& region, const Contour& clip) const;

    /// The region's pixels, as scan conversion has them: left and top sides in, right and bottom
    /// sides out.
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
