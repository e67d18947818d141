// Coverage by edge functions: the top-left rule, lines and points.
#include "gw/reference/coverage.h"

#include "gw/stages/fan.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace gw::reference {

std::int64_t area2(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c) {
    return gw::area2({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
}

SnappedTriangle snapped_triangle(const std::array<WindowVertex, 3>& v, const JitterState& jitter,
                                 int subpixel_bits) {
    SnappedTriangle t;
    t.subpixel_bits = subpixel_bits;
    t.area2 = area2(v[0], v[1], v[2]);
    if (t.area2 < 0) {
        std::swap(t.source[1], t.source[2]);
        t.area2 = -t.area2;
    }
    const auto before = [&](std::size_t a, std::size_t b) {
        return std::pair(v[a].y, v[a].x) < std::pair(v[b].y, v[b].x);
    };
    std::rotate(t.source.begin(), std::min_element(t.source.begin(), t.source.end(), before),
                t.source.end());
    for (std::size_t i = 0; i < 3; ++i) {
        t.x[i] = v[t.source[i]].x + jitter.x;
        t.y[i] = v[t.source[i]].y + jitter.y;
    }
    return t;
}

SnappedLine snapped_line(const WindowVertex& a, const WindowVertex& b, const JitterState& jitter,
                         int subpixel_bits) {
    const LineEnds ends{{a.x + jitter.x, b.x + jitter.x}, {a.y + jitter.y, b.y + jitter.y}};
    return {ends, ends.x_major(), subpixel_bits};
}

namespace {

/// Floor of a / b, b > 0.
std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

std::int64_t center(std::int64_t pixel, int s) {
    return (pixel << s) + (std::int64_t{1} << (s - 1));
}

/// The first pixel and one past the last whose centre may lie in [low, high], clamped to
/// [from, from + size).
std::pair<int, int> pixel_range(std::int64_t low, std::int64_t high, int s, int from, int size) {
    const std::int64_t first = std::max<std::int64_t>(low >> s, from);
    const std::int64_t last = std::min<std::int64_t>((high >> s) + 1, std::int64_t{from} + size);
    return {int(first), int(std::max(first, last))};
}

}  // namespace

// e(P) = A (PX - a.X) + B (PY - a.Y). Points on an edge belong to it if it is a left or top edge.
Side side_at(const SnappedTriangle& t, std::size_t i, int x, int y) {
    const std::int64_t px = center(x, t.subpixel_bits), py = center(y, t.subpixel_bits);
    const std::size_t j = (i + 1) % 3;
    const std::int64_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
    const bool top_left = dy < 0 || (dy == 0 && dx < 0);
    return {dx, dy, top_left, -dy * (px - t.x[i]) + dx * (py - t.y[i]) - (top_left ? 0 : 1)};
}

bool covers(const SnappedTriangle& t, int x, int y) {
    return side_at(t, 0, x, y).e >= 0 && side_at(t, 1, x, y).e >= 0 && side_at(t, 2, x, y).e >= 0;
}

void cover_triangle(const SnappedTriangle& t, const Rect& box, const PixelSink& pixel) {
    const auto [x_low, x_high] = std::minmax_element(t.x.begin(), t.x.end());
    const auto [y_low, y_high] = std::minmax_element(t.y.begin(), t.y.end());
    const auto [x0, x1] = pixel_range(*x_low, *x_high, t.subpixel_bits, box.x, box.width);
    const auto [y0, y1] = pixel_range(*y_low, *y_high, t.subpixel_bits, box.y, box.height);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            if (covers(t, x, y)) pixel(x, y);
}

void cover_line(const SnappedLine& line, const LineRule& rule, const Rect& box,
                const PixelSink& pixel) {
    // u is the coordinate along the major axis, v the other.
    const int s = line.subpixel_bits;
    const auto& u = line.x_major ? line.x : line.y;
    const auto& v = line.x_major ? line.y : line.x;
    const std::int64_t du = u[1] - u[0], dv = v[1] - v[0];
    if (du == 0) return;  // no length, because |du| >= |dv|
    const LineSteps steps = line_steps(line, rule);
    const int u_low = line.x_major ? box.x : box.y,
              u_high = u_low + (line.x_major ? box.width : box.height);
    const int v_low = line.x_major ? box.y : box.x,
              v_high = v_low + (line.x_major ? box.height : box.width);
    for (std::int64_t i = std::max<std::int64_t>(steps.low(), u_low);
         i < std::min<std::int64_t>(steps.high(), u_high); ++i) {
        // The first row is floor((v(p) - (width - 1) 2^(s-1)) / 2^s) with the exact
        // v(p) = v0 + dv (p - u0) / du.
        const std::int64_t d = std::abs(du);
        const std::int64_t v_times_d = v[0] * d + (du > 0 ? dv : -dv) * (center(i, s) - u[0]);
        const std::int64_t below = (rule.width - 1) * (d << s) / 2 + boundary_step(line, rule);
        const std::int64_t first = floor_div(v_times_d - below, d << s);
        for (int j = int(std::max<std::int64_t>(first, v_low));
             j < std::min<std::int64_t>(first + rule.width, v_high); ++j) {
            if (line.x_major)
                pixel(int(i), j);
            else
                pixel(j, int(i));
        }
    }
}

bool is_between_ends(const SnappedLine& line, int x, int y) {
    const auto& u = line.x_major ? line.x : line.y;
    const std::int64_t p = center(line.x_major ? x : y, line.subpixel_bits);
    return std::min(u[0], u[1]) <= p && p <= std::max(u[0], u[1]);
}

void cover_point(std::int64_t x, std::int64_t y, int size, int s, const Rect& box,
                 const PixelSink& pixel) {
    const std::int64_t shift = (size - 1) * (std::int64_t{1} << (s - 1));
    const std::int64_t x0 = (x - shift) >> s, y0 = (y - shift) >> s;
    for (std::int64_t j = std::max<std::int64_t>(y0, box.y);
         j < std::min<std::int64_t>(y0 + size, box.y + box.height); ++j)
        for (std::int64_t i = std::max<std::int64_t>(x0, box.x);
             i < std::min<std::int64_t>(x0 + size, box.x + box.width); ++i)
            pixel(int(i), int(j));
}

}  // namespace gw::reference
