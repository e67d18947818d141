// [GL11] 3.3, 3.4.2, 3.5.1: antialiasing by the area that a primitive covers in a pixel's square.
#include "gw/reference/smooth.h"

#include <algorithm>

namespace gw::reference {
namespace {

/// Calls fragment(x, y, coverage, shape) for each pixel whose coverage is not 0, row by row.
void for_each_covered(const Areas& areas, int bits, const auto& fragment) {
    for (const auto& [at, covered] : areas.pixels()) {
        const std::uint32_t coverage = coverage_of(covered.area, bits);
        if (coverage != 0) fragment(at.second, at.first, coverage, covered.shape);
    }
}

}  // namespace

void Areas::add_around(Shape corners, std::size_t ordinal, const auto& area_at) {
    const PixelRange range = pixels_around(corners);
    for (int y = std::max(range.y0, box_.y); y < std::min(range.y1, box_.y + box_.height); ++y)
        for (int x = std::max(range.x0, box_.x); x < std::min(range.x1, box_.x + box_.width); ++x) {
            const std::int64_t area = area_at(x, y);
            if (area == 0) continue;
            Covered& pixel = pixels_[{y, x}];
            // More than a pixel stays more: corners of a polygon have no limit.
            pixel.area = std::min(pixel.area + area, std::int64_t{2} << area_bits);
            if (area > pixel.largest) {
                pixel.largest = area;
                pixel.shape = ordinal;
            }
        }
}

void Areas::add(Shape shape, std::size_t ordinal) {
    add_around(shape, ordinal, [&](int x, int y) { return area_inside(shape, x, y); });
}

void Areas::add(const Disc& disc) {
    add_around(disc.corners, 0, [&](int x, int y) { return disc.area(x, y); });
}

void draw_smooth_polygon(const std::vector<SmoothPiece>& pieces) {
    if (pieces.empty()) return;
    const DrawContext& context = pieces[0].shade.context;
    Areas areas(context.state.draw_box);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const SnappedTriangle& t = pieces[i].triangle;
        std::array<ShapePoint, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = {shape_coordinate(t.x[k], t.subpixel_bits),
                          shape_coordinate(t.y[k], t.subpixel_bits)};
        areas.add(corners, i);
    }
    const auto& pattern = context.state.state.polygon_stipple.pattern;
    for_each_covered(areas, context.profile->coverage_bits,
                     [&](int x, int y, std::uint32_t coverage, std::size_t largest) {
                         if (pattern && !stipple_bit(*pattern, x, y)) return;
                         for (const SmoothPiece& piece : pieces)
                             if (covers(piece.triangle, x, y))
                                 return piece.shade.pixel(x, y, coverage);
                         pieces[largest].shade.outside_pixel(x, y, coverage);
                     });
}

void draw_smooth_line(const Shader& shade, const SnappedLine& line, std::uint64_t stippled) {
    const State& state = shade.context.state.state;
    const SmoothLine smooth = smooth_line({line.x[0], line.y[0]}, {line.x[1], line.y[1]},
                                          state.line_width, line.subpixel_bits);
    Areas areas(shade.context.state.draw_box);
    for (const auto& rectangle : line_shapes(smooth, state.line_stipple, stippled))
        areas.add(rectangle, 0);
    for_each_covered(areas, shade.context.profile->coverage_bits,
                     [&](int x, int y, std::uint32_t coverage, std::size_t) {
                         if (is_between_ends(line, x, y))
                             shade.pixel(x, y, coverage);
                         else
                             shade.outside_pixel(x, y, coverage);
                     });
}

void draw_smooth_point(const Shader& shade, std::int64_t x, std::int64_t y, float size) {
    const int s = shade.context.profile->subpixel_bits;
    Areas areas(shade.context.state.draw_box);
    areas.add(disc({shape_coordinate(x, s), shape_coordinate(y, s)}, half_size(size)));
    for_each_covered(
        areas, shade.context.profile->coverage_bits,
        [&](int i, int k, std::uint32_t coverage, std::size_t) { shade.pixel(i, k, coverage); });
}

}  // namespace gw::reference
