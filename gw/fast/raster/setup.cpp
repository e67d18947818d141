#include "gw/fast/raster/setup.h"

#include "gw/fast/frame/frame.h"
#include "gw/fast/vertices/geometry.h"

#include <algorithm>
#include <cstdlib>

namespace gw::fast {

std::array<int128, 2> PrimitiveFrame::exact_gradients(const std::array<std::int64_t, 3>& a) const {
    if (kind == MeshKind::Points) return {0, 0};
    if (kind == MeshKind::Lines) {
        const int128 g = exact_gradient(a[1 - base] - a[base], 16 + s, length);
        return {x_major ? g : 0, x_major ? 0 : g};
    }
    const std::int64_t da1 = a[1] - a[0], da2 = a[2] - a[0];
    return {exact_gradient(da1 * dy2 - da2 * dy1, 16 + s, area2),
            exact_gradient(da2 * dx1 - da1 * dx2, 16 + s, area2)};
}

/// The same, mostly without a division of 128 bits.
std::array<int128, 2> PrimitiveFrame::gradients(const std::array<std::int64_t, 3>& a) const {
    if (kind != MeshKind::Triangles) return exact_gradients(a);
    const std::int64_t da1 = a[1] - a[0], da2 = a[2] - a[0];
    bool sliver = false;
    const int128 gx = gradient(da1 * dy2 - da2 * dy1, 16 + s, area2, sliver),
                 gy = gradient(da2 * dx1 - da1 * dx2, 16 + s, area2, sliver);
    return sliver ? exact_gradients(a) : std::array{gx, gy};
}

LimitedPlane PrimitiveFrame::limited_of(const std::array<std::int64_t, 3>& a) const {
    const auto used = a.begin() + (kind == MeshKind::Triangles ? 3
                                   : kind == MeshKind::Lines   ? 2
                                                               : 1);
    const auto [low, high] = std::minmax_element(a.begin(), used);
    return {gradients(a), a[base], x[base], y[base], *low, *high, s};
}

TilePlane PrimitiveFrame::plane_at_place(const std::array<std::int64_t, 3>& a) const {
    TilePlane p = constant(limited_of(a).at(place_x, place_y));
    p.sliver = true;  // its gradients are not the primitive's
    return p;
}

PrimitiveFrame primitive_frame(const GeometrySet& set, const SetupPrimitive& p,
                               const JitterState& jitter, int s, const Tile& tile) {
    PrimitiveFrame f;
    f.kind = p.kind;
    f.s = s;
    f.stippled = p.stippled;
    for (std::size_t i = 0; i < 3; ++i) {
        f.x[i] = std::int64_t{set.at[p.vertex[i]].x} + jitter.x;
        f.y[i] = std::int64_t{set.at[p.vertex[i]].y} + jitter.y;
    }
    f.dx1 = f.x[1] - f.x[0];
    f.dy1 = f.y[1] - f.y[0];
    f.dx2 = f.x[2] - f.x[0];
    f.dy2 = f.y[2] - f.y[0];
    if (p.kind == MeshKind::Triangles) f.area2 = f.dx1 * f.dy2 - f.dx2 * f.dy1;
    if (p.kind == MeshKind::Lines) {
        f.x_major = std::abs(f.dx1) >= std::abs(f.dy1);
        const std::int64_t d = f.x_major ? f.dx1 : f.dy1;
        f.length = std::abs(d);
        f.base = d > 0 ? 0 : 1;
    }
    const std::int64_t half = std::int64_t{1} << (s - 1);
    const std::int64_t xr = f.x[f.base] >> s, yr = f.y[f.base] >> s;
    f.ax = (xr << s) + half - f.x[f.base];
    f.ay = (yr << s) + half - f.y[f.base];
    f.to_x = tile.x - xr;
    f.to_y = tile.y - yr;
    return f;
}

TileEdges tile_edges(const PrimitiveFrame& f, const Tile& tile) {
    constexpr std::int64_t limit = std::int64_t{1} << 30;
    const std::int64_t half = std::int64_t{1} << (f.s - 1);
    const std::int64_t px = (std::int64_t{tile.x} << f.s) + half,
                       py = (std::int64_t{tile.y} << f.s) + half;
    TileEdges e;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::int64_t dx = f.x[j] - f.x[i], dy = f.y[j] - f.y[i];
        const bool top_left = dy < 0 || (dy == 0 && dx < 0);
        const std::int64_t c = -dy * (px - f.x[i]) + dx * (py - f.y[i]) - (top_left ? 0 : 1);
        // A pixel step adds a multiple of 2^s, so the low s bits never decide; the clamp keeps
        // every sign in the tile.
        e.c[i] = static_cast<std::int32_t>(std::clamp(c >> f.s, -limit, limit));
        e.a[i] = static_cast<std::int32_t>(-dy);
        e.b[i] = static_cast<std::int32_t>(dx);
    }
    return e;
}

}  // namespace gw::fast
