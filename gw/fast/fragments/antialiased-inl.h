// Antialiased primitives in a tile: the covered area of each pixel, then the fragment stages with
// alpha multiplied by it. docs/manual/rasterization.md, "Antialiasing"; scalar twin:
// gw/reference/smooth.cpp. Included once per Highway target.
#if defined(GW_FAST_ANTIALIASED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_ANTIALIASED_INL_H_
#undef GW_FAST_ANTIALIASED_INL_H_
#else
#define GW_FAST_ANTIALIASED_INL_H_
#endif

#include "gw/fast/fragments/smooth_painter-inl.h"
#include "gw/fast/raster/cover-inl.h"
#include "gw/stages/area.h"
#include "gw/stages/raster/points.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>
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

    /// Begins a polygon or a line of these shapes.
    void begin(const auto& shapes, bool polygon) {
        is_polygon_ = polygon;
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
        add(shape, ordinal,
            [&](int i, int j) { return area_inside(shape, draw.tile.x + i, draw.tile.y + j); });
    }
    /// The same of areas by area_of(tile column, row).
    void add(Shape shape, std::uint32_t ordinal, const auto& area_of) {
        for_each(range_of(shape), [&](Pixel& p, int i, int j) {
            const std::int64_t area = area_of(i, j);
            p.area = std::min(p.area + area, std::int64_t{2} << area_bits);
            if (area <= p.largest) return;
            p.largest = area;
            if (!p.inside) p.shape = ordinal;
        });
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
    /// Calls visit(bx, by, coverage, inside, outside) for each block: the lanes with the values of
    /// one shape, whose centres are inside it or outside all shapes.
    void for_each_block(std::uint32_t shape, const auto& visit) const {
        for (int by = range_.y0 / block_side; by * block_side < range_.y1; ++by)
            for (int bx = range_.x0 / block_side; bx * block_side < range_.x1; ++bx) {
                CoverageBlock coverage;
                std::uint32_t inside = 0, outside = 0;
                for (int lane = 0; lane < int(block_pixels); ++lane) {
                    const Pixel& p = at(bx, by, lane);
                    coverage.lane[lane] = p.coverage;
                    if (p.coverage != 0 && p.shape == shape && !is_left_out(bx, by, lane))
                        (p.inside ? inside : outside) |= 1u << lane;
                }
                visit(bx, by, coverage, inside, outside);
            }
    }

    const TileDraw& draw;

private:
    const Pixel& at(int bx, int by, int lane) const {
        static constexpr Pixel none;
        const int x = bx * block_side + lane % block_side, y = by * block_side + lane / block_side;
        const bool inside = x >= range_.x0 && x < range_.x1 && y >= range_.y0 && y < range_.y1;
        return inside ? pixels_[index(x, y)] : none;
    }
    /// Only polygons have a pattern.
    bool is_left_out(int bx, int by, int lane) const {
        const auto& pattern = draw.op->state.state.polygon_stipple.pattern;
        return is_polygon_ && pattern &&
               !stipple_bit(*pattern, draw.tile.x + bx * block_side + lane % block_side,
                            draw.tile.y + by * block_side + lane / block_side);
    }
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
    std::vector<Pixel> pixels_;     ///< of range_
    PixelRange range_{0, 0, 0, 0};  ///< of the shapes
    bool is_polygon_ = true;
};

/// A triangle's corners on the grid of shapes.
HWY_INLINE std::array<ShapePoint, 3> shape_of(const PrimitiveFrame& f) {
    std::array<ShapePoint, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = {shape_coordinate(f.x[k], f.s), shape_coordinate(f.y[k], f.s)};
    return corners;
}

/// The areas of a tile's pixels inside a triangle. Most pixels lie on one side of each edge.
class TriangleAreas {
public:
    TriangleAreas(const TileDraw& draw, Shape corners, const TileEdges& edges)
        : draw_(draw), corners_(corners), e_(edges) {
        for (std::size_t k = 0; k < 3; ++k)
            reach_[k] = (std::abs(e_.a[k]) + std::abs(e_.b[k])) / 2 + 2;
    }
    std::int64_t operator()(int x, int y) const {
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const int center = at(k, x, y);
            if (center + reach_[k] < 0) return 0;
            inside = inside && center >= reach_[k];
        }
        if (inside) return std::int64_t{1} << area_bits;
        return area_inside(corners_, draw_.tile.x + x, draw_.tile.y + y);
    }
    bool has_center(int x, int y) const {
        return at(0, x, y) >= 0 && at(1, x, y) >= 0 && at(2, x, y) >= 0;
    }

private:
    /// Its integer part: the edge function is less than 2 above it.
    int at(std::size_t k, int x, int y) const { return e_.c[k] + e_.a[k] * x + e_.b[k] * y; }

    const TileDraw& draw_;
    Shape corners_;
    TileEdges e_;
    std::array<int, 3> reach_;  ///< from a pixel's centre to its corners
};

/// Paints the pixels that have the values of one shape.
inline void paint_shape(const SmoothTile& pixels, std::uint32_t ordinal, std::uint32_t shape,
                        OpCounts& counts) {
    Corners corners;
    gather_corners(pixels.draw, {&ordinal, 1}, corners);
    BatchPlanes planes(pixels.draw, corners);
    const PrimitiveFrame frame = frame_of(pixels.draw, ordinal);
    SmoothPainter painter(planes, 0, frame, counts);
    pixels.for_each_block(
        shape, [&](int bx, int by, const CoverageBlock& coverage, std::uint32_t inside,
                   std::uint32_t outside) { painter.paint(bx, by, coverage, inside, outside); });
}

/// The pieces of one polygon.
inline void draw_smooth_polygon(SmoothTile& pixels, std::span<const std::uint32_t> pieces,
                                OpCounts& counts) {
    const TileDraw& draw = pixels.draw;
    std::vector<std::array<ShapePoint, 3>> shapes;
    for (const std::uint32_t piece : pieces) shapes.push_back(shape_of(frame_of(draw, piece)));
    pixels.begin(shapes, true);
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        const PrimitiveFrame frame = frame_of(draw, pieces[i]);
        const auto& corners = shapes[i];
        const TriangleAreas areas(draw, corners, tile_edges(frame, draw.tile));
        pixels.add(corners, i, areas);
        pixels.claim(corners, i, [&](int x, int y) { return areas.has_center(x, y); });
    }
    pixels.finish();
    for (std::uint32_t i = 0; i < pieces.size(); ++i) paint_shape(pixels, pieces[i], i, counts);
}

/// The pixels of the tile whose centres lie between the ends of a line, along its major axis.
inline BlockBox between_ends(const TileDraw& draw, const PrimitiveFrame& f) {
    const auto& u = f.x_major ? f.x : f.y;
    const std::int64_t half = std::int64_t{1} << (f.s - 1);
    const std::int64_t first = (std::min(u[0], u[1]) - half + 2 * half - 1) >> f.s,
                       last = (std::max(u[0], u[1]) - half) >> f.s;
    const int length = int(last - first) + 1;
    return block_box(f.x_major ? Rect{int(first), draw.tile.y, length, draw.tile.side}
                               : Rect{draw.tile.x, int(first), draw.tile.side, length},
                     draw.tile);
}

/// A line whose stipple leaves out steps of it.
inline void draw_stippled_smooth_line(SmoothTile& pixels, std::uint32_t ordinal, OpCounts& counts) {
    const TileDraw& draw = pixels.draw;
    const State& state = draw.op->state.state;
    const PrimitiveFrame f = frame_of(draw, ordinal);
    const SmoothLine line = smooth_line({f.x[0], f.y[0]}, {f.x[1], f.y[1]}, state.line_width, f.s);
    const BlockBox inner = between_ends(draw, f);
    const auto shapes = line_shapes(line, state.line_stipple, f.stippled);
    pixels.begin(shapes, false);
    for (const auto& rectangle : shapes) {
        pixels.add(rectangle, 0);
        pixels.claim(rectangle, 0, [&](int x, int y) {
            return inner.x0 <= x && x < inner.x1 && inner.y0 <= y && y < inner.y1;
        });
    }
    pixels.finish();
    paint_shape(pixels, ordinal, 0, counts);
}

/// The disc of points around (0, 0), kept for the next tiles with points of this size. Valid until
/// the next call.
inline const ShapeSides& disc_of(float point_size) {
    constexpr std::size_t most_kept = 64;
    thread_local std::map<float, ShapeSides> kept;
    if (const auto found = kept.find(point_size); found != kept.end()) return found->second;
    ShapeSides sides;
    sides.set(disc({0, 0}, half_size(point_size)).corners);
    if (kept.size() == most_kept) kept.clear();
    return kept[point_size] = std::move(sides);
}

/// Points, and lines without stipple: one shape each. Draws them in batches.
class SmoothShapes {
public:
    SmoothShapes(const TileDraw& draw, OpCounts& counts) : draw_(draw), counts_(counts) {}

    void add(std::uint32_t ordinal) {
        waiting_[count_++] = ordinal;
        if (count_ == batch_capacity) draw();
    }
    /// Draws those that were added.
    void draw() {
        if (count_ == 0) return;
        Corners corners;
        gather_corners(draw_, std::span(waiting_).first(count_), corners);
        BatchPlanes planes(draw_, corners);
        for (std::size_t i = 0; i < count_; ++i) {
            const PrimitiveFrame frame = frame_of(draw_, waiting_[i]);
            frame.kind == MeshKind::Points ? draw_point(planes, i, frame)
                                           : draw_line(planes, i, frame);
        }
        count_ = 0;
    }

private:
    void draw_point(BatchPlanes& planes, std::size_t i, const PrimitiveFrame& frame) {
        find(disc_of(frame.point_size),
             {shape_coordinate(frame.x[0], frame.s), shape_coordinate(frame.y[0], frame.s)});
        SmoothPainter painter(planes, i, frame, counts_);
        coverage_.for_each_block(
            [&](int bx, int by, const CoverageBlock& coverage, std::uint32_t lanes) {
                painter.paint(bx, by, coverage, lanes, 0);
            });
    }
    void draw_line(BatchPlanes& planes, std::size_t i, const PrimitiveFrame& frame) {
        const SmoothLine line = smooth_line({frame.x[0], frame.y[0]}, {frame.x[1], frame.y[1]},
                                            draw_.op->state.state.line_width, frame.s);
        rectangle_.set(line.rectangle(0, line.steps));
        find(rectangle_, {0, 0});
        const BlockBox inner = between_ends(draw_, frame);
        SmoothPainter painter(planes, i, frame, counts_);
        coverage_.for_each_block(
            [&](int bx, int by, const CoverageBlock& coverage, std::uint32_t lanes) {
                const std::uint32_t inside = lanes & inner.mask(bx, by);
                painter.paint(bx, by, coverage, inside, lanes & ~inside);
            });
    }
    void find(const ShapeSides& shape, ShapePoint to) {
        const PixelRange r = shape.pixels(to);
        const BlockBox& box = draw_.box;
        const Tile& tile = draw_.tile;
        coverage_.find(shape, to,
                       {std::max(r.x0 - tile.x, box.x0), std::max(r.y0 - tile.y, box.y0),
                        std::min(r.x1 - tile.x, box.x1), std::min(r.y1 - tile.y, box.y1)},
                       tile.x, tile.y, draw_.profile->coverage_bits);
    }

    const TileDraw& draw_;
    OpCounts& counts_;
    std::array<std::uint32_t, batch_capacity> waiting_;
    std::size_t count_ = 0;
    ShapeSides rectangle_;
    ShapeCoverage coverage_;
};

/// Draws a bin under a state that may antialias. Smooth pieces of one polygon come together, after
/// the lines and points of its outline. Others are drawn by `triangle` and `other`.
template <class Triangle, class Other>
inline void draw_antialiased(const TileDraw& draw, std::span<const std::uint32_t> bin,
                             OpCounts& counts, const Triangle& triangle, const Other& other) {
    const State& s = draw.op->state.state;
    const auto& primitives = draw.op->set->primitives;
    SmoothTile pixels(draw);
    SmoothShapes shapes(draw, counts);
    std::vector<std::uint32_t> pieces;
    const auto draw_now = [&](std::uint32_t ordinal, const auto& way) {
        shapes.draw();
        way(ordinal);
    };
    const auto stippled = [&](std::uint32_t ordinal) {
        draw_stippled_smooth_line(pixels, ordinal, counts);
    };
    for (std::size_t i = 0; i < bin.size(); ++i) {
        const SetupPrimitive& p = primitives[bin[i]];
        switch (p.kind) {
            case MeshKind::Triangles:
                s.polygon_smooth ? pieces.push_back(bin[i]) : draw_now(bin[i], triangle);
                break;
            case MeshKind::Lines:
                if (!s.line_smooth)
                    draw_now(bin[i], other);
                else
                    s.line_stipple.enable ? draw_now(bin[i], stippled) : shapes.add(bin[i]);
                break;
            case MeshKind::Points:
                smooths_points(s) ? shapes.add(bin[i]) : draw_now(bin[i], other);
                break;
        }
        const bool polygon_ends = i + 1 == bin.size() || primitives[bin[i + 1]].part != p.part ||
                                  primitives[bin[i + 1]].polygon != p.polygon;
        if (!polygon_ends || pieces.empty()) continue;
        shapes.draw();
        draw_smooth_polygon(pixels, pieces, counts);
        pieces.clear();
    }
    shapes.draw();
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
