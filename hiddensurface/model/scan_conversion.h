// Polygons to rows of pixels. [L7] Does not know depth or colour.
#pragma once

#include "hiddensurface/model/grid.h"

#include <span>

namespace gw::hiddensurface {

/// Walks an edge downwards, row by row: x_{i+1} = x_i - 1/m as an integer DDA. It carries the
/// remainder, so that x agrees exactly with the closed form after any number of rows. [L7]
class EdgeWalk {
public:
    /// Starts at the edge's top row, or at row `highest` if that is lower. An edge has the rows whose
    /// centres are above its lower end and not above its upper end. The ends may come in any order.
    EdgeWalk(const GridPoint& a, const GridPoint& b, int subpixel_bits, int highest);

    int row() const { return row_; }
    bool done() const { return row_ < last_; }
    /// The first pixel whose centre is not left of the edge.
    int x() const { return static_cast<int>(x_); }
    void down();

private:
    int row_ = 0, last_ = 0;
    std::int64_t height_ = 1;     ///< D: the edge's height times 2^subpixel_bits
    std::int64_t x_ = 0;          ///< ceil(n / D)
    std::int64_t remainder_ = 0;  ///< x D - n: 0 .. D - 1
    std::int64_t step_ = 0, step_remainder_ = 0;
};

/// The runs of a polygon inside `window`, from the top row down, left to right: between crossings 1
/// and 2, 3 and 4, ... of every row. Its corners are joined in order. Points on left and top edges
/// belong to it, points on right and bottom edges do not, as when the machine draws a triangle.
std::vector<Run> scan_convert(std::span<const GridPoint> corners, int subpixel_bits,
                              const Rect& window);

}  // namespace gw::hiddensurface
