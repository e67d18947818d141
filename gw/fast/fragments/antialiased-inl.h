// Antialiased primitives in a tile: the covered area of each pixel, then the fragment stages with
// alpha multiplied by it. docs/manual/rasterization.md, "Antialiasing"; scalar twin:
// gw/reference/smooth.cpp. Included once per Highway target.
#if defined(GW_FAST_ANTIALIASED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_ANTIALIASED_INL_H_
#undef GW_FAST_ANTIALIASED_INL_H_
#else
#define GW_FAST_ANTIALIASED_INL_H_
#endif

#include "gw/fast/fragments/fragments-inl.h"
#include "gw/fast/raster/cover-inl.h"
#include "gw/fast/shade/batch-inl.h"
#include "gw/stages/area.h"

#include <bit>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The pixels of a tile that the shapes of one primitive cover.
class SmoothTile {
public:
    struct Pixel {
        std::int64_t area = 0, largest = 0;
        std::uint32_t shape = 0;  ///< whose values it has: inside, or of the largest area
        bool inside = false;      ///< its centre is inside that shape
        std::uint16_t coverage = 0;
    };

    explicit SmoothTile(const TileDraw& d) : draw(d) {}

    /// Begins a primitive of these shapes.
    void begin(const auto& shapes) {
        range_ = {draw.tile.side, draw.tile.side, 0, 0};
        for (const Shape shape : shapes) {
            const PixelRange r = range_of(shape);
            if (r.x0 >= r.x1 || r.y0 >= r.y1) continue;
            range_ = {std::min(range_.x0, r.x0), std::min(range_.y0, r.y0),
                      std::max(range_.x1, r.x1), std::max(range_.y1, r.y1)};
        }
        const int width = std::max(0, range_.x1 - range_.x0),
                  height = std::max(0, range_.y1 - range_.y0);
        pixels_.assign(std::size_t(width) * std::size_t(height), {});
    }
    void add(Shape shape, std::uint32_t ordinal) {
        add_around(shape, ordinal, [&](int x, int y) { return area_inside(shape, x, y); });
    }
    void add(const Disc& disc) {
        add_around(disc.corners, 0, [&](int x, int y) { return disc.area(x, y); });
    }
    /// Pixels whose centre is inside a shape, by is_inside(tile column, row); the first shape wins.
    void claim(Shape shape, std::uint32_t ordinal, const auto& is_inside) {
        for_each(range_of(shape), [&](Pixel& p, int i, int j) {
            if (p.inside || !is_inside(i, j)) return;
            p.inside = true;
            p.shape = ordinal;
        });
    }
    void finish() {
        const int bits = draw.profile->coverage_bits;
        for_each(range_, [&](Pixel& p, int, int) {
            p.coverage = std::uint16_t(coverage_of(p.area, bits));
        });
    }
    /// Calls visit(bx, by) for the blocks that the primitive's shapes reach.
    void for_each_block(const auto& visit) const {
        for (int by = range_.y0 / block_side; by * block_side < range_.y1; ++by)
            for (int bx = range_.x0 / block_side; bx * block_side < range_.x1; ++bx) visit(bx, by);
    }
    const Pixel& at(int bx, int by, int lane) const {
        static constexpr Pixel none;
        const int x = bx * block_side + lane % block_side, y = by * block_side + lane / block_side;
        const bool inside = x >= range_.x0 && x < range_.x1 && y >= range_.y0 && y < range_.y1;
        return inside ? pixels_[index(x, y)] : none;
    }

    const TileDraw& draw;

private:
    PixelRange range_of(Shape shape) const {
        const PixelRange r = pixels_around(shape);
        const BlockBox& box = draw.box;
        return {std::max(r.x0 - draw.tile.x, box.x0), std::max(r.y0 - draw.tile.y, box.y0),
                std::min(r.x1 - draw.tile.x, box.x1), std::min(r.y1 - draw.tile.y, box.y1)};
    }
    void for_each(const PixelRange& r, const auto& visit) {
        for (int j = r.y0; j < r.y1; ++j)
            for (int i = r.x0; i < r.x1; ++i) visit(pixels_[index(i, j)], i, j);
    }
    std::size_t index(int x, int y) const {
        return std::size_t(y - range_.y0) * std::size_t(range_.x1 - range_.x0) +
               std::size_t(x - range_.x0);
    }
    void add_around(Shape corners, std::uint32_t ordinal, const auto& area_at) {
        const PixelRange range = range_of(corners);
        for_each(range, [&](Pixel& p, int i, int j) {
            const std::int64_t area = area_at(draw.tile.x + i, draw.tile.y + j);
            p.area = std::min(p.area + area, std::int64_t{2} << area_bits);
            if (area <= p.largest) return;
            p.largest = area;
            if (!p.inside) p.shape = ordinal;
        });
    }

    std::vector<Pixel> pixels_;     ///< of range_
    PixelRange range_{0, 0, 0, 0};  ///< of the shapes
};

/// One primitive's fragments in the pixels that have its values.
struct SmoothPainter {
    const SmoothTile& pixels;
    const TileDraw& draw;
    std::uint32_t ordinal, shape;
    OpCounts& counts;
    Corners corners;
    PrimitiveFrame frame;
    ColorBlock covered;

    SmoothPainter(const SmoothTile& p, std::uint32_t ordinal_, std::uint32_t shape_, OpCounts& c)
        : pixels(p), draw(p.draw), ordinal(ordinal_), shape(shape_), counts(c) {
        gather_corners(draw, {&ordinal, 1}, corners);
        frame = frame_of(draw, ordinal);
    }

    void paint() {
        BatchPlanes planes(draw, corners);
        const DepthPlane depth = depth_plane(draw, *corners.primitive[0], frame);
        pixels.for_each_block([&](int bx, int by) {
            std::uint32_t inside = 0, outside = 0;
            for (int lane = 0; lane < int(block_pixels); ++lane) {
                const SmoothTile::Pixel& p = pixels.at(bx, by, lane);
                if (p.coverage != 0 && p.shape == shape && !is_left_out(bx, by, lane))
                    (p.inside ? inside : outside) |= 1u << lane;
            }
            if (inside != 0)
                run(depth, bx, by, inside,
                    [&]() -> const ColorBlock& { return planes.color_of(0, bx, by, inside); });
            for (; outside != 0; outside &= outside - 1)
                paint_outside(bx, by, std::countr_zero(outside));
        });
    }

private:
    bool is_left_out(int bx, int by, int lane) const {
        const auto& pattern = draw.op->state.state.polygon_stipple.pattern;
        return pattern && frame.kind == MeshKind::Triangles &&
               !stipple_bit(*pattern, draw.tile.x + bx * block_side + lane % block_side,
                            draw.tile.y + by * block_side + lane / block_side);
    }

    void run(const DepthPlane& plane, int bx, int by, std::uint32_t mask, const auto& color) {
        DepthBlock depth;
        shade_depth(plane, max_of_bits(draw.profile->depth_bits), bx, by, depth);
        run_fragments(draw.op->state, corners.primitive[0]->front != 0, depth, draw.tile,
                      draw.tile.block(bx, by), mask, counts, [&]() -> const ColorBlock& {
                          covered = color();
                          for (int lane = 0; lane < int(block_pixels); ++lane) {
                              std::uint16_t& alpha = covered.channel[3][lane];
                              alpha = covered_alpha(alpha, pixels.at(bx, by, lane).coverage,
                                                    draw.profile->coverage_bits);
                          }
                          return covered;
                      });
    }

    /// One pixel whose centre is outside: planes are constant there.
    void paint_outside(int bx, int by, int lane) {
        const SetupPrimitive& primitive = *corners.primitive[0];
        const auto center = [&](int pixel) {
            return (std::int64_t{pixel} << frame.s) + (std::int64_t{1} << (frame.s - 1));
        };
        PrimitiveFrame at = frame;
        at.limited = true;
        at.pixel_x = center(draw.tile.x + bx * block_side + lane % block_side);
        at.pixel_y = center(draw.tile.y + by * block_side + lane / block_side);
        const std::uint32_t mask = 1u << lane;
        ShadeInputs in;
        run(depth_plane(draw, primitive, at), bx, by, mask, [&]() -> const ColorBlock& {
            ColorPlanes color;
            make_color_planes(draw, primitive, at, color);
            wide_colors(color, *draw.op, bx, by, mask, in);
            if (draw.op->texels) {
                TexturePlanes texture;
                make_texture_planes(draw, primitive, at, texture);
                look_up(texture, draw, bx, by, mask, in);
            }
            return shaded(draw, in.texel, in);
        });
    }
};

/// A triangle's corners on the grid of shapes.
HWY_INLINE std::array<ShapePoint, 3> shape_of(const PrimitiveFrame& f) {
    std::array<ShapePoint, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = {shape_coordinate(f.x[k], f.s), shape_coordinate(f.y[k], f.s)};
    return corners;
}

/// The pieces of one polygon.
inline void draw_smooth_polygon(SmoothTile& pixels, std::span<const std::uint32_t> pieces,
                                OpCounts& counts) {
    const TileDraw& draw = pixels.draw;
    std::vector<std::array<ShapePoint, 3>> shapes;
    for (const std::uint32_t piece : pieces) shapes.push_back(shape_of(frame_of(draw, piece)));
    pixels.begin(shapes);
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        const PrimitiveFrame frame = frame_of(draw, pieces[i]);
        const auto& corners = shapes[i];
        const TileEdges e = tile_edges(frame, draw.tile);
        pixels.add(corners, i);
        pixels.claim(corners, i, [&](int x, int y) {
            return e.c[0] + e.a[0] * x + e.b[0] * y >= 0 && e.c[1] + e.a[1] * x + e.b[1] * y >= 0 &&
                   e.c[2] + e.a[2] * x + e.b[2] * y >= 0;
        });
    }
    pixels.finish();
    for (std::uint32_t i = 0; i < pieces.size(); ++i)
        SmoothPainter(pixels, pieces[i], i, counts).paint();
}

inline void draw_smooth_line(SmoothTile& pixels, std::uint32_t ordinal, OpCounts& counts) {
    const TileDraw& draw = pixels.draw;
    const State& state = draw.op->state.state;
    const PrimitiveFrame f = frame_of(draw, ordinal);
    const SmoothLine line = smooth_line({f.x[0], f.y[0]}, {f.x[1], f.y[1]}, state.line_width, f.s);
    const auto& u = f.x_major ? f.x : f.y;
    const std::int64_t low = std::min(u[0], u[1]), high = std::max(u[0], u[1]);
    const auto is_between_ends = [&](int x, int y) {
        const std::int64_t pixel = f.x_major ? draw.tile.x + x : draw.tile.y + y;
        const std::int64_t p = (pixel << f.s) + (std::int64_t{1} << (f.s - 1));
        return low <= p && p <= high;
    };
    const auto shapes = line_shapes(line, state.line_stipple, f.stippled);
    pixels.begin(shapes);
    for (const auto& rectangle : shapes) {
        pixels.add(rectangle, 0);
        pixels.claim(rectangle, 0, is_between_ends);
    }
    pixels.finish();
    SmoothPainter(pixels, ordinal, 0, counts).paint();
}

inline void draw_smooth_point(SmoothTile& pixels, std::uint32_t ordinal, OpCounts& counts) {
    const TileDraw& draw = pixels.draw;
    const PrimitiveFrame f = frame_of(draw, ordinal);
    const Disc point = disc({shape_coordinate(f.x[0], f.s), shape_coordinate(f.y[0], f.s)},
                            half_size(draw.op->state.state.point_size));
    pixels.begin(std::array{Shape(point.corners)});
    pixels.add(point);
    pixels.claim(point.corners, 0, [](int, int) { return true; });
    pixels.finish();
    SmoothPainter(pixels, ordinal, 0, counts).paint();
}

/// Draws a bin under a state that may antialias. Smooth pieces of one polygon come together, after
/// the lines and points of its outline. Others are drawn by `triangle` and `other`.
template <class Triangle, class Other>
inline void draw_antialiased(const TileDraw& draw, std::span<const std::uint32_t> bin,
                             OpCounts& counts, const Triangle& triangle, const Other& other) {
    const State& s = draw.op->state.state;
    const auto& primitives = draw.op->set->primitives;
    SmoothTile pixels(draw);
    std::vector<std::uint32_t> pieces;
    for (std::size_t i = 0; i < bin.size(); ++i) {
        const SetupPrimitive& p = primitives[bin[i]];
        switch (p.kind) {
            case MeshKind::Triangles:
                s.polygon_smooth ? pieces.push_back(bin[i]) : triangle(bin[i]);
                break;
            case MeshKind::Lines:
                s.line_smooth ? draw_smooth_line(pixels, bin[i], counts) : other(bin[i]);
                break;
            case MeshKind::Points:
                s.point_smooth ? draw_smooth_point(pixels, bin[i], counts) : other(bin[i]);
                break;
        }
        const bool polygon_ends = i + 1 == bin.size() || primitives[bin[i + 1]].part != p.part ||
                                  primitives[bin[i + 1]].polygon != p.polygon;
        if (!polygon_ends || pieces.empty()) continue;
        draw_smooth_polygon(pixels, pieces, counts);
        pieces.clear();
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
