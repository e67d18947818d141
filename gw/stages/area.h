// The area of a pixel that a shape covers, and its use as coverage.
// docs/manual/rasterization.md, "Antialiasing". Does not choose the pixels or their values.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/stages/stipple.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace gw {

/// Shapes have corners on a grid of 2^-12 pixel.
inline constexpr int shape_bits = 12;
inline constexpr std::int64_t shape_pixel = std::int64_t{1} << shape_bits;
using ShapePoint = std::array<std::int64_t, 2>;
/// Corners counter-clockwise.
using Shape = std::span<const ShapePoint>;

/// Areas are in units of 2^-40 pixel.
inline constexpr int area_bits = 40;

/// A snapped coordinate on the grid of shapes.
constexpr std::int64_t shape_coordinate(std::int64_t v, int subpixel_bits) {
    return v * (std::int64_t{1} << (shape_bits - subpixel_bits));
}

/// The area of pixel (x, y) to the left of the side from a to b, between their heights; negative if
/// the side goes down. Odd in its direction, so the two areas of a shared side cancel.
inline std::int64_t area_left_of(ShapePoint a, ShapePoint b, int x, int y) {
    if (a[1] > b[1]) return -area_left_of(b, a, x, y);
    const std::int64_t left = x * shape_pixel, bottom = y * shape_pixel;
    const std::int64_t y0 = std::max(a[1], bottom), y1 = std::min(b[1], bottom + shape_pixel);
    if (y0 >= y1) return 0;
    const std::int64_t dx = b[0] - a[0], dy = b[1] - a[1];
    constexpr int to_area = area_bits - 2 * shape_bits;
    // dy times the distance of the side from the pixel's left border, at y0 and y1
    const std::int64_t right = shape_pixel * dy;
    const std::int64_t n0 = (a[0] - left) * dy + (y0 - a[1]) * dx,
                       n1 = (a[0] - left) * dy + (y1 - a[1]) * dx;
    if (n0 <= 0 && n1 <= 0) return 0;
    if (n0 >= right && n1 >= right) return (shape_pixel * (y1 - y0)) << to_area;
    if (dx == 0) return ((a[0] - left) * (y1 - y0)) << to_area;
    // 2 dy^2 times the integral of the distance, which is limited to the pixel
    const auto h = [&](std::int64_t n) {
        if (n <= 0) return int128{0};
        return n <= right ? int128{n} * n : int128{right} * (2 * n - right);
    };
    const int128 twice = (h(n1) - h(n0)) * (int128{1} << to_area);
    const int128 divisor = int128{2} * dx * dy;
    return std::int64_t(divisor > 0 ? divide_round_even(twice, divisor)
                                    : divide_round_even(-twice, -divisor));
}

/// The area of pixel (x, y) inside a shape.
inline std::int64_t area_inside(Shape shape, int x, int y) {
    std::int64_t area = 0;
    for (std::size_t k = 0; k < shape.size(); ++k)
        area += area_left_of(shape[k], shape[(k + 1) % shape.size()], x, y);
    return area;
}

/// Half the size of a point or line on the grid of shapes.
inline std::int64_t half_size(float size) { return std::int64_t(round_even(2048 * double(size))); }

/// A disc as a polygon with 8 n corners, symmetric as a square is. The larger, the more corners.
struct Disc {
    ShapePoint center{};
    std::int64_t radius = 0;
    std::vector<ShapePoint> corners{};

    /// The area of pixel (x, y) inside the disc.
    std::int64_t area(int x, int y) const {
        if (surrounds(x, y)) return std::int64_t{1} << area_bits;
        return area_inside(corners, x, y);
    }

private:
    /// Whether the pixel lies deep inside; most pixels of large discs do.
    bool surrounds(int x, int y) const {
        const auto reach = [&](std::int64_t pixel, std::size_t k) {
            const std::int64_t d = pixel * shape_pixel - center[k];
            return std::max(d + shape_pixel, -d);
        };
        const std::int64_t dx = reach(x, 0), dy = reach(y, 1), deep = radius - 16;
        return deep > 0 && dx * dx + dy * dy < deep * deep;
    }
};

/// Points on an eighth of a circle: a tangent of half the angle gives both coordinates.
inline Disc disc(const ShapePoint& center, std::int64_t radius) {
    std::int64_t n = 8;
    while (32 * n * n < radius) n *= 2;
    std::vector<ShapePoint> quarter;
    for (std::int64_t k = 0; k < n; ++k) {
        const double t = double(2 * k + 1) * (std::sqrt(2.0) - 1) / double(2 * n), d = 1 + t * t;
        quarter.push_back({std::int64_t(round_even(double(radius) * ((1 - t * t) / d))),
                           std::int64_t(round_even(double(radius) * ((t + t) / d)))});
    }
    for (std::int64_t k = n; k-- > 0;) {
        const ShapePoint p = quarter[std::size_t(k)];
        quarter.push_back({p[1], p[0]});
    }
    Disc out{center, radius};
    for (int turn = 0; turn < 4; ++turn)
        for (ShapePoint& p : quarter) {
            out.corners.push_back({center[0] + p[0], center[1] + p[1]});
            p = {-p[1], p[0]};
        }
    return out;
}

/// An area as a fraction of the pixel, in the profile's bits.
constexpr std::uint32_t coverage_of(std::int64_t area, int bits) {
    constexpr std::int64_t pixel = std::int64_t{1} << area_bits;
    const std::int64_t inside = std::clamp<std::int64_t>(area, 0, pixel);
    return std::uint32_t((inside * max_of_bits(bits) + pixel / 2) >> area_bits);
}

/// Nearest integer to alpha * coverage / (2^bits - 1); no ties exist.
constexpr std::uint16_t covered_alpha(std::uint32_t alpha, std::uint32_t coverage, int bits) {
    const std::uint64_t one = max_of_bits(bits);
    return std::uint16_t((std::uint64_t{2} * alpha * coverage + one) / (2 * one));
}

/// A smooth line: a rectangle around the segment from a to b, jitter included.
struct SmoothLine {
    ShapePoint a{}, b{};
    ShapePoint side{};  ///< from the segment to the rectangle's left side
    double length = 0;  ///< on the grid of shapes
    std::int64_t steps = 0;

    /// The end of step n on the segment.
    ShapePoint at(std::int64_t n) const {
        if (n >= steps) return b;
        const auto along = [&](std::size_t k) {
            return a[k] +
                   std::int64_t(round_even(double(n * shape_pixel * (b[k] - a[k])) / length));
        };
        return {along(0), along(1)};
    }
    /// The rectangle over steps [first, end).
    std::array<ShapePoint, 4> rectangle(std::int64_t first, std::int64_t end) const {
        const ShapePoint p = at(first), q = at(end);
        return {ShapePoint{p[0] - side[0], p[1] - side[1]},
                {q[0] - side[0], q[1] - side[1]},
                {q[0] + side[0], q[1] + side[1]},
                {p[0] + side[0], p[1] + side[1]}};
    }
};

/// The length of a line in sub-pixels; exact before its one rounding.
inline double line_length(std::int64_t dx, std::int64_t dy) {
    return std::sqrt(double(dx * dx + dy * dy));
}
/// The steps of a smooth line: whole pixels of its length, and the rest.
inline std::int64_t smooth_steps(std::int64_t dx, std::int64_t dy, int subpixel_bits) {
    return std::int64_t(std::ceil(line_length(dx, dy) / double(1 << subpixel_bits)));
}

/// From snapped ends that differ.
inline SmoothLine smooth_line(ShapePoint a, ShapePoint b, float width, int subpixel_bits) {
    const std::int64_t dx = b[0] - a[0], dy = b[1] - a[1];
    const double length = line_length(dx, dy), half = double(half_size(width));
    const auto on_grid = [&](const ShapePoint& p) {
        return ShapePoint{shape_coordinate(p[0], subpixel_bits),
                          shape_coordinate(p[1], subpixel_bits)};
    };
    return {on_grid(a),
            on_grid(b),
            {-std::int64_t(round_even(half * double(dy) / length)),
             std::int64_t(round_even(half * double(dx) / length))},
            length * double(std::int64_t{1} << (shape_bits - subpixel_bits)),
            smooth_steps(dx, dy, subpixel_bits)};
}

/// The rectangles of a line: one, or one for each step that the stipple leaves.
inline std::vector<std::array<ShapePoint, 4>> line_shapes(const SmoothLine& line,
                                                          const LineStippleState& stipple,
                                                          std::uint64_t before) {
    if (!stipple.enable) return {line.rectangle(0, line.steps)};
    std::vector<std::array<ShapePoint, 4>> shapes;
    for (std::int64_t n = 0; n < line.steps; ++n)
        if (stipple_bit(stipple, before + std::uint64_t(n)))
            shapes.push_back(line.rectangle(n, n + 1));
    return shapes;
}

/// The pixels [x0, x1) x [y0, y1) that a shape may reach.
struct PixelRange {
    int x0, y0, x1, y1;
};
inline PixelRange pixels_around(Shape shape) {
    ShapePoint low = shape[0], high = shape[0];
    for (const ShapePoint& p : shape)
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    const auto end = [](std::int64_t v) { return int((v + shape_pixel - 1) >> shape_bits); };
    return {int(low[0] >> shape_bits), int(low[1] >> shape_bits), end(high[0]), end(high[1])};
}

}  // namespace gw
