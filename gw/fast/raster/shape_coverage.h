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

/// A shape as corners and sides in pixels.
class ShapeSides {
public:
    /// The side from a corner to the next.
    struct Side {
        double x, y0, y1;  ///< x at y0, its lower end
        double slope;      ///< dx / dy
        double sign;       ///< 1: upwards, -1: downwards, 0: level
    };
    struct Corner {
        double x, y;
        double integral;  ///< of x dy, from the first corner on
    };
    /// So many sides in turn are looked at together.
    static constexpr std::size_t step = 4;

    void set(Shape shape);

    Shape corners() const { return corners_; }
    std::span<const Side> sides() const { return sides_; }
    /// The corners, and the first one again.
    std::span<const Corner> path() const { return path_; }
    /// Whether x and y each only grow or only fall over every `step` sides from a multiple of it on.
    bool is_monotone() const { return monotone_; }
    /// The pixels that it may reach if it is moved by `to`, on the grid of shapes.
    PixelRange pixels(ShapePoint to) const {
        return pixels_around(std::array{ShapePoint{low_[0] + to[0], low_[1] + to[1]},
                                        ShapePoint{high_[0] + to[0], high_[1] + to[1]}});
    }

private:
    std::vector<ShapePoint> corners_;
    std::vector<Side> sides_;
    std::vector<Corner> path_;
    bool monotone_ = false;
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
    /// A pixel of the range; none: column -1.
    struct Pixel {
        int column = -1, row = -1;
        bool operator==(const Pixel&) const = default;
    };

    Pixel pixel_at(double x, double y) const;
    void add_sides(const ShapeSides& shape, double x, double y);
    void add_run(const ShapeSides::Corner& from, const ShapeSides::Corner& to, double x,
                 const Pixel& pixel);
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
