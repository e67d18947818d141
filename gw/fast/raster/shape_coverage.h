// The coverage of a tile's pixels by one antialiased shape: a disc or a rectangle. Areas are sums in
// double, which decide unless a pixel's area comes near a tie; gw/stages/area.h, the scalar twin,
// decides there. Does not choose the values of fragments.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/stages/area.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::fast {

/// A shape as sides in pixels, without level ones.
class ShapeSides {
public:
    struct Side {
        double x, y0, y1;  ///< x at y0, its lower end
        double x1;         ///< at y1
        double slope;      ///< dx / dy
        double sign;       ///< 1: upwards, -1: downwards
    };

    void set(Shape shape);

    Shape corners() const { return corners_; }
    std::span<const Side> sides() const { return sides_; }
    /// The pixels that it may reach if it is moved by `to`, on the grid of shapes.
    PixelRange pixels(ShapePoint to) const {
        return pixels_around(std::array{ShapePoint{low_[0] + to[0], low_[1] + to[1]},
                                        ShapePoint{high_[0] + to[0], high_[1] + to[1]}});
    }

private:
    std::vector<ShapePoint> corners_;
    std::vector<Side> sides_;
    ShapePoint low_{}, high_{};
};

/// The coverage of each pixel of one block.
struct alignas(32) CoverageBlock {
    std::uint16_t lane[block_pixels];
};

/// The coverage of a range of a tile's pixels, by blocks.
class ShapeCoverage {
public:
    /// Finds the coverage by a shape that is moved by `to`, on the grid of shapes. The range is of
    /// the tile's pixels, from the window's pixel (tile_x, tile_y) on.
    void find(const ShapeSides& shape, ShapePoint to, const PixelRange& range, int tile_x,
              int tile_y, int coverage_bits);

    /// Calls visit(bx, by, coverage, lanes) for each block with lanes that are covered.
    template <class Visit>
    void for_each_block(const Visit& visit) const {
        for (int by = 0; by < rows_; ++by)
            for (int bx = 0; bx < columns_; ++bx) {
                const std::size_t i = std::size_t(by * columns_ + bx);
                if (lanes_[i] != 0) visit(first_x_ + bx, first_y_ + by, blocks_[i], lanes_[i]);
            }
    }

private:
    /// The columns of a row that its sides cross, or beside which they pass.
    struct Row {
        int first, last;
    };

    void begin(const PixelRange& range);
    /// What the sides that came last add to the one pixel that they stay in.
    struct Pixel {
        int column = 0, row = -1;
        double area = 0, left = 0;
    };

    void add_sides(const ShapeSides& shape, double x, double y);
    bool add_in_pixel(const ShapeSides::Side& side, double x, double y, Pixel& pixel);
    void add_pixel(const Pixel& pixel);
    void add_side(const ShapeSides::Side& side, double x, double y);
    void add_to_row(int row, double height, double low, double high);
    void put(int column, int row, std::uint32_t coverage);

    PixelRange range_{};
    int width_ = 0, height_ = 0;  ///< of the range
    std::vector<Row> crossed_;
    /// Of each pixel: what the sides that cross it add, and what they add to each pixel on the left.
    /// In rows of `width_` + 1; zero between calls.
    std::vector<double> area_, left_;
    std::vector<CoverageBlock> blocks_;
    std::vector<std::uint16_t> lanes_;  ///< of blocks_, those that are covered
    int first_x_ = 0, first_y_ = 0, columns_ = 0, rows_ = 0;  ///< of blocks_
};

}  // namespace gw::fast
