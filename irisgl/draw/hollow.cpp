// PYM_HOLLOW: the pixels at a polygon's edge, in the colours that they have when it is filled.
#include "irisgl/draw/primitives.h"

#include "irisgl/draw/apply.h"
#include "irisgl/draw/picking.h"
#include "irisgl/state/program.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gw::irisgl {

namespace {

/// Pixels of the window, and some beside it.
class PixelSet {
public:
    explicit PixelSet(const Bounds& box)
        : box_(box), in_(std::size_t(box.width()) * std::size_t(box.height())) {}

    const Bounds& box() const { return box_; }
    bool has(int x, int y) const {
        return x >= box_.left && x <= box_.right && y >= box_.bottom && y <= box_.top &&
               in_[place(x, y)];
    }
    void add(int x, int y) { in_[place(x, y)] = true; }

private:
    std::size_t place(int x, int y) const {
        return std::size_t(y - box_.bottom) * std::size_t(box_.width()) +
               std::size_t(x - box_.left);
    }

    Bounds box_;
    std::vector<bool> in_;
};

/// The outline on the machine's sub-pixel grid; empty: a vertex is behind the eye.
std::vector<dvec2> outline_on_screen(std::span<const Vertex> outline) {
    const double grid = 1 << current_window().profile().subpixel_bits;
    std::vector<dvec2> points;
    for (const Vertex& v : outline) {
        const auto at = window_from_object(v.p);
        if (!at || !std::isfinite(at->x) || !std::isfinite(at->y)) return {};
        points.push_back(
            {std::floor(at->x * grid + 0.5) / grid, std::floor(at->y * grid + 0.5) / grid});
    }
    return points;
}

/// The window's part of the outline's box, and a pixel more on each side.
Bounds box_of(const std::vector<dvec2>& points) {
    const Window& w = current_window();
    Bounds box{w.width(), -1, w.height(), -1};
    for (const dvec2& p : points) {
        box.left = std::min(box.left, int(std::clamp(std::floor(p.x), -1.0, 1.0 * w.width())));
        box.right = std::max(box.right, int(std::clamp(std::ceil(p.x), -1.0, 1.0 * w.width())));
        box.bottom = std::min(box.bottom, int(std::clamp(std::floor(p.y), -1.0, 1.0 * w.height())));
        box.top = std::max(box.top, int(std::clamp(std::ceil(p.y), -1.0, 1.0 * w.height())));
    }
    return box;
}

/// docs/manual/rasterization.md, R9.2: a centre on a side counts as one a little to the right, and much
/// less below it.
PixelSet pixels_inside(const std::vector<dvec2>& points) {
    constexpr double right = 1e-5, below = 1e-9;
    PixelSet set(box_of(points));
    const Bounds& box = set.box();
    for (int y = box.bottom; y <= box.top; ++y) {
        const double row = y + 0.5 - below;
        std::vector<double> sides;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const dvec2 &a = points[i], &b = points[(i + 1) % points.size()];
            if ((a.y > row) != (b.y > row))
                sides.push_back(a.x + (row - a.y) * (b.x - a.x) / (b.y - a.y));
        }
        std::sort(sides.begin(), sides.end());
        for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
            for (int x = box.left; x <= box.right; ++x)
                if (x + 0.5 + right > sides[i] && x + 0.5 + right < sides[i + 1]) set.add(x, y);
    }
    return set;
}

bool is_at_edge(const PixelSet& inside, int x, int y) {
    return inside.has(x, y) && !(inside.has(x - 1, y) && inside.has(x + 1, y) &&
                                 inside.has(x, y - 1) && inside.has(x, y + 1));
}

/// The edge in a square of 32 x 32 pixels as OpenGL's stipple, inside the pattern.
std::array<GLubyte, 128> stipple_at(const PixelSet& inside, int left, int bottom, bool& is_empty) {
    const Pattern* const pattern = pattern_now();
    std::array<GLubyte, 128> out{};
    is_empty = true;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            if (!is_at_edge(inside, left + x, bottom + y)) continue;
            if (pattern != nullptr && !pattern->bit(left + x, bottom + y)) continue;
            out[std::size_t(y * 4 + x / 8)] |= GLubyte(0x80 >> x % 8);
            is_empty = false;
        }
    return out;
}

void draw_edge(const PixelSet& inside, const std::function<void()>& draw) {
    const Window& w = current_window();
    const Bounds &m = state().screen_mask, &box = inside.box();
    const Bounds in{std::max({box.left, m.left, 0}), std::min({box.right, m.right, w.width() - 1}),
                    std::max({box.bottom, m.bottom, 0}),
                    std::min({box.top, m.top, w.height() - 1})};
    glEnable(GL_POLYGON_STIPPLE);
    for (int y = in.bottom & ~31; y <= in.top; y += 32)
        for (int x = in.left & ~31; x <= in.right; x += 32) {
            bool is_empty = false;
            const auto stipple = stipple_at(inside, x, y, is_empty);
            if (is_empty) continue;
            const int left = std::max(x, in.left), bottom = std::max(y, in.bottom);
            glScissor(left, bottom, std::min(x + 31, in.right) - left + 1,
                      std::min(y + 31, in.top) - bottom + 1);
            glPolygonStipple(stipple.data());
            draw();
        }
    apply_viewport();
    apply_pattern();
}

void draw_polygon(std::span<const Vertex> outline, const std::function<void()>& draw) {
    const std::vector<dvec2> points = outline_on_screen(outline);
    if (!points.empty()) return draw_edge(pixels_inside(points), draw);
    warn("polymode: a hollow polygon that reaches behind the eye is drawn as lines");
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    draw();
    apply_polygons();
}

}  // namespace

bool draws_hollow() { return state().polygon_mode == PYM_HOLLOW && !gives_feedback() && !picks(); }

void draw_hollow(Shape shape, std::span<const Vertex> vertices, std::span<const Vertex> outline,
                 const std::function<void(Shape, std::span<const Vertex>)>& draw) {
    const auto piece = [&](Shape as, const std::vector<Vertex>& v,
                           const std::vector<Vertex>& edge) {
        draw_polygon(edge, [&] { draw(as, v); });
    };
    if (!outline.empty()) return draw_polygon(outline, [&] { draw(shape, vertices); });
    const auto& v = vertices;
    if (shape == Shape::Triangles)
        for (std::size_t i = 0; i + 2 < v.size(); i += 3)
            piece(shape, {v[i], v[i + 1], v[i + 2]}, {v[i], v[i + 1], v[i + 2]});
    if (shape == Shape::Mesh)  // every second triangle runs the other way round
        for (std::size_t i = 0; i + 2 < v.size(); ++i) {
            const std::vector<Vertex> corners{v[i + i % 2], v[i + 1 - i % 2], v[i + 2]};
            piece(Shape::Triangles, corners, corners);
        }
    if (shape == Shape::Strip)
        for (std::size_t i = 0; i + 3 < v.size(); i += 2)
            piece(shape, {v[i], v[i + 1], v[i + 2], v[i + 3]},
                  {v[i], v[i + 1], v[i + 3], v[i + 2]});
}

}  // namespace gw::irisgl
