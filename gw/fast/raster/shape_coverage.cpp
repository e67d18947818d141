#include "gw/fast/raster/shape_coverage.h"

#include "gw/base/arithmetic.h"

#include <algorithm>
#include <utility>

namespace gw::fast {
namespace {

/// Doubles decide unless an area is this near to a tie, in pixels. At most 1024 sides meet in a
/// pixel. Each adds an error below 2^-36 here and below 2^-40 in area_inside().
constexpr double doubt = 1.0 / double(1 << 24);

double in_pixels(std::int64_t v) { return double(v) / double(shape_pixel); }

}  // namespace

void ShapeSides::set(Shape shape) {
    corners_.assign(shape.begin(), shape.end());
    sides_.clear();
    path_.clear();
    low_ = high_ = corners_[0];
    double integral = 0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        ShapePoint a = corners_[k], b = corners_[(k + 1) % corners_.size()];
        for (std::size_t i = 0; i < 2; ++i) {
            low_[i] = std::min(low_[i], a[i]);
            high_[i] = std::max(high_[i], a[i]);
        }
        path_.push_back({in_pixels(a[0]), in_pixels(a[1]), integral});
        integral += in_pixels(a[0] + b[0]) / 2 * in_pixels(b[1] - a[1]);
        const double sign = double((a[1] < b[1]) - (a[1] > b[1]));
        if (sign < 0) std::swap(a, b);
        const double slope = sign == 0 ? 0 : double(b[0] - a[0]) / double(b[1] - a[1]);
        sides_.push_back({in_pixels(a[0]), in_pixels(a[1]), in_pixels(b[1]), slope, sign});
    }
    path_.push_back({path_[0].x, path_[0].y, integral});
    monotone_ = sides_.size() % step == 0;
    for (std::size_t k = 0; monotone_ && k < sides_.size(); k += step) {
        const std::span<const Corner> part(&path_[k], step + 1);
        const auto goes_one_way = [&](double Corner::*of) {
            const auto grows = [of](const Corner& l, const Corner& r) { return l.*of < r.*of; };
            const auto falls = [of](const Corner& l, const Corner& r) { return l.*of > r.*of; };
            return std::is_sorted(part.begin(), part.end(), grows) ||
                   std::is_sorted(part.begin(), part.end(), falls);
        };
        monotone_ = goes_one_way(&Corner::x) && goes_one_way(&Corner::y);
    }
}

void ShapeCoverage::begin(const PixelRange& range) {
    range_ = range;
    width_ = range.x1 - range.x0;
    height_ = range.y1 - range.y0;
    crossed_.assign(std::size_t(height_), {width_, -1});
    const std::size_t size = std::size_t(width_ + 1) * std::size_t(height_);
    if (area_.size() < size) {
        area_.resize(size, 0);
        left_.resize(size, 0);
    }
    first_x_ = range.x0 / block_side;
    first_y_ = range.y0 / block_side;
    columns_ = (range.x1 - 1) / block_side + 1 - first_x_;
    rows_ = (range.y1 - 1) / block_side + 1 - first_y_;
    blocks_.assign(std::size_t(columns_ * rows_), {});
    lanes_.assign(blocks_.size(), 0);
}

/// A part of a side that stays in one row: its height, and its least and largest x.
void ShapeCoverage::add_to_row(int row, double height, double low, double high) {
    Row& crossed = crossed_[std::size_t(row)];
    double* const area = &area_[std::size_t(row) * std::size_t(width_ + 1)];
    double* const left = &left_[std::size_t(row) * std::size_t(width_ + 1)];
    const int first = low <= 0 ? 0 : int(std::min(low, double(width_))),
              last = high <= 0 ? 0 : int(std::min(high, double(width_ - 1)));
    crossed.first = std::min(crossed.first, first);
    crossed.last = std::max(crossed.last, last);
    if (high <= 0) return;
    left[first] += height;
    if (low >= width_) return;
    const double mean = (low + high) / 2;
    if (low >= 0 && high <= first + 1) {
        area[first] += height * (mean - first);
        return;
    }
    // the mean of max(x - i, 0) from low to high
    const double scale = 0.5 / (high - low);
    const auto beyond = [&](int i) {
        if (i <= low) return mean - i;
        return i < high ? (high - i) * (high - i) * scale : 0.0;
    };
    double here = beyond(first);
    for (int i = first; i <= last; ++i) {
        const double next = beyond(i + 1);
        area[i] += height * (here - next);
        here = next;
    }
}

void ShapeCoverage::add_side(const ShapeSides::Side& side, double x, double y) {
    const double low = side.y0 + y, end = std::min(side.y1 + y, double(height_));
    const auto x_at = [&](double at) { return side.x + x + (at - low) * side.slope; };
    double y0 = std::max(low, 0.0), x0 = x_at(y0);
    for (int row = int(y0); y0 < end; ++row) {
        const double y1 = std::min(end, double(row + 1)), x1 = x_at(y1);
        add_to_row(row, (y1 - y0) * side.sign, std::min(x0, x1), std::max(x0, x1));
        y0 = y1;
        x0 = x1;
    }
}

ShapeCoverage::Pixel ShapeCoverage::pixel_at(double x, double y) const {
    const bool inside = x >= 0 && x < width_ && y >= 0 && y < height_;
    return inside ? Pixel{int(x), int(y)} : Pixel{};
}

/// Sides in turn that stay in one pixel.
void ShapeCoverage::add_run(const ShapeSides::Corner& from, const ShapeSides::Corner& to, double x,
                            const Pixel& pixel) {
    Row& crossed = crossed_[std::size_t(pixel.row)];
    crossed.first = std::min(crossed.first, pixel.column);
    crossed.last = std::max(crossed.last, pixel.column);
    const std::size_t i =
        std::size_t(pixel.row) * std::size_t(width_ + 1) + std::size_t(pixel.column);
    const double height = to.y - from.y;
    area_[i] += to.integral - from.integral + (x - pixel.column) * height;
    left_[i] += height;
}

/// Most sides of discs are short: several in turn stay in one pixel.
void ShapeCoverage::add_sides(const ShapeSides& shape, double x, double y) {
    const auto path = shape.path();
    const auto sides = shape.sides();
    const auto pixel_of = [&](std::size_t k) { return pixel_at(path[k].x + x, path[k].y + y); };
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const Pixel pixel = pixel_of(k);
        std::size_t end = k;
        while (pixel.row >= 0 && end < sides.size()) {
            const bool steps = shape.is_monotone() && end % ShapeSides::step == 0;
            if (steps && pixel_of(end + ShapeSides::step) == pixel)
                end += ShapeSides::step;
            else if (pixel_of(end + 1) == pixel)
                ++end;
            else
                break;
        }
        if (end != k) add_run(path[k], path[end], x, pixel);
        k = end;
        if (k < sides.size() && sides[k].sign != 0) add_side(sides[k], x, y);
    }
}

/// The coverage of a pixel of the range.
void ShapeCoverage::put(int column, int row, std::uint32_t coverage) {
    if (coverage == 0) return;
    const int x = range_.x0 + column, y = range_.y0 + row;
    const auto block =
        std::size_t((y / block_side - first_y_) * columns_ + x / block_side - first_x_);
    const int lane = y % block_side * block_side + x % block_side;
    blocks_[block].lane[lane] = std::uint16_t(coverage);
    lanes_[block] = std::uint16_t(lanes_[block] | 1u << lane);
}

void ShapeCoverage::find(const ShapeSides& shape, ShapePoint to, const PixelRange& range,
                         int tile_x, int tile_y, int coverage_bits) {
    columns_ = rows_ = 0;
    if (range.x0 >= range.x1 || range.y0 >= range.y1) return;
    begin(range);
    const int window_x = tile_x + range.x0, window_y = tile_y + range.y0;
    const double x = in_pixels(to[0] - window_x * shape_pixel),
                 y = in_pixels(to[1] - window_y * shape_pixel);
    add_sides(shape, x, y);

    const auto exact = [&](int column, int row) {
        std::vector<ShapePoint> moved;
        for (const ShapePoint& p : shape.corners()) moved.push_back({p[0] + to[0], p[1] + to[1]});
        return coverage_of(area_inside(moved, window_x + column, window_y + row), coverage_bits);
    };
    const double one = max_of_bits(coverage_bits), near = doubt * one;
    for (int row = 0; row < height_; ++row) {
        double* const area = &area_[std::size_t(row) * std::size_t(width_ + 1)];
        double* const left = &left_[std::size_t(row) * std::size_t(width_ + 1)];
        const Row& crossed = crossed_[std::size_t(row)];
        // Left of the first column, the parts of all sides cancel.
        double sum = std::exchange(left[width_], 0.0);
        for (int i = crossed.last; i >= crossed.first; --i) {
            const double scaled = std::clamp(area[i] + sum, 0.0, 1.0) * one + 0.5;
            sum += left[i];
            area[i] = left[i] = 0;
            const double rest = scaled - int(scaled);
            const bool unsure = rest < near || rest > 1 - near;
            put(i, row, unsure ? exact(i, row) : std::uint32_t(scaled));
        }
    }
}

}  // namespace gw::fast
