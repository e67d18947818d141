// Which pixels of a tile a triangle, line or point covers, a block at a time. docs/manual.md, "Coverage";
// scalar twin: gw/reference/triangle.cpp. Does not interpolate or test.
// Included once per Highway target.
#if defined(GW_FAST_COVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COVER_INL_H_
#undef GW_FAST_COVER_INL_H_
#else
#define GW_FAST_COVER_INL_H_
#endif

#include "gw/fast/planes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Edge functions as vectors: c + a i + b j of a block's 16 lanes.
struct EdgeLanes {
    TileEdges edges;
    alignas(64) std::int32_t lane[3][16];
};

HWY_INLINE void make_edge_lanes(EdgeLanes& e) {
    const I32 d;
    const D32 u;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            const auto x = hn::BitCast(d, hn::Load(u, lane_x + i)),
                       y = hn::BitCast(d, hn::Load(u, lane_y + i));
            const auto v =
                hn::Add(hn::Mul(hn::Set(d, e.edges.a[k]), x), hn::Mul(hn::Set(d, e.edges.b[k]), y));
            hn::Store(v, d, e.lane[k] + i);
        }
}

/// Lanes of block (bx, by) whose centres are inside all three edges.
HWY_INLINE std::uint32_t covered(const EdgeLanes& e, int bx, int by) {
    const I32 d;
    const TileEdges& t = e.edges;
    std::int32_t base[3];
    for (std::size_t k = 0; k < 3; ++k)
        base[k] = t.c[k] + t.a[k] * (bx * block_side) + t.b[k] * (by * block_side);
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto e0 = hn::Add(hn::Set(d, base[0]), hn::Load(d, e.lane[0] + i));
        const auto e1 = hn::Add(hn::Set(d, base[1]), hn::Load(d, e.lane[1] + i));
        const auto e2 = hn::Add(hn::Set(d, base[2]), hn::Load(d, e.lane[2] + i));
        const auto outside = hn::Lt(hn::Or(hn::Or(e0, e1), e2), hn::Zero(d));  // any sign bit
        mask |= bits_of(D32(), hn::RebindMask(D32(), outside), lanes32) << i;
    }
    return ~mask & all_lanes;
}

/// Pixels of the tile that may be touched: [x0, x1) x [y0, y1).
struct PixelBounds {
    int x0, y0, x1, y1;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
};

HWY_INLINE PixelBounds bounds_in_tile(const TileDraw& draw, const PrimitiveFrame& f) {
    const auto [x_low, x_high] = std::minmax({f.x[0], f.x[1], f.x[2]});
    const auto [y_low, y_high] = std::minmax({f.y[0], f.y[1], f.y[2]});
    const std::int64_t half = std::int64_t{1} << (f.s - 1);
    const BlockBox& box = draw.box;
    const auto clamp = [](std::int64_t v, int low, int high) {
        return int(std::clamp<std::int64_t>(v, low, high));
    };
    return {clamp(((x_low + half - 1) >> f.s) - draw.tile.x, box.x0, box.x1),
            clamp(((y_low + half - 1) >> f.s) - draw.tile.y, box.y0, box.y1),
            clamp(((x_high - half) >> f.s) + 1 - draw.tile.x, box.x0, box.x1),
            clamp(((y_high - half) >> f.s) + 1 - draw.tile.y, box.y0, box.y1)};
}

/// How a triangle covers a rectangle of pixels, as far as its edges tell.
enum class Extent { Outside, Partial, Inside };

/// Of the pixels [x0, x1] x [y0, y1] of the tile.
HWY_INLINE Extent extent_of(const TileEdges& e, int x0, int y0, int x1, int y1) {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t least = e.c[k] + e.a[k] * (e.a[k] > 0 ? x0 : x1) + e.b[k] * (e.b[k] > 0 ? y0 : y1);
        const std::int32_t most = e.c[k] + e.a[k] * (e.a[k] > 0 ? x1 : x0) + e.b[k] * (e.b[k] > 0 ? y1 : y0);
        if (most < 0) return Extent::Outside;
        inside = inside && least >= 0;
    }
    return inside ? Extent::Inside : Extent::Partial;
}

/// Blocks are visited in groups of 4x4, so that a large triangle's empty and full parts cost next to nothing.
inline constexpr int group_blocks = 4;

template <class Visit>
HWY_INLINE void visit_triangle(const TileDraw& draw, const PrimitiveFrame& frame, const Visit& visit) {
    const PixelBounds b = bounds_in_tile(draw, frame);
    if (b.empty()) return;
    EdgeLanes edges;
    edges.edges = tile_edges(frame, draw.tile);
    make_edge_lanes(edges);
    const int bx0 = b.x0 / block_side, bx1 = (b.x1 - 1) / block_side, by0 = b.y0 / block_side,
              by1 = (b.y1 - 1) / block_side;
    const bool small = bx1 - bx0 < 2 && by1 - by0 < 2;
    for (int gy = by0; gy <= by1; gy += group_blocks)
        for (int gx = bx0; gx <= bx1; gx += group_blocks) {
            const int ex = std::min(gx + group_blocks - 1, bx1), ey = std::min(gy + group_blocks - 1, by1);
            const Extent extent =
                small ? Extent::Partial
                      : extent_of(edges.edges, gx * block_side, gy * block_side,
                                  ex * block_side + block_side - 1, ey * block_side + block_side - 1);
            if (extent == Extent::Outside) continue;
            for (int by = gy; by <= ey; ++by)
                for (int bx = gx; bx <= ex; ++bx) {
                    const std::uint32_t inside =
                        extent == Extent::Inside ? all_lanes : covered(edges, bx, by);
                    const std::uint32_t mask = inside & draw.box.mask(bx, by);
                    if (mask != 0) visit(bx, by, mask);
                }
        }
}

/// Pixels of a line or point, collected by block, then sent on in block order.
struct PixelSet {
    std::uint16_t mask[256] = {};
    int blocks_per_row = 16;
    void add(int x, int y) {
        auto& m = mask[std::size_t(y / block_side * blocks_per_row + x / block_side)];
        m = std::uint16_t(m | (1u << (y % block_side * block_side + x % block_side)));
    }
};

/// Rows from floor((v(p) - (width - 1) 2^(s-1)) / 2^s) in each column whose centre the line passes.
inline void line_pixels(const TileDraw& draw, const PrimitiveFrame& f, int width, PixelSet& out) {
    const int s = f.s;
    const auto& u = f.x_major ? f.x : f.y;
    const auto& v = f.x_major ? f.y : f.x;
    const int u_tile = f.x_major ? draw.tile.x : draw.tile.y, v_tile = f.x_major ? draw.tile.y : draw.tile.x;
    const BlockBox& b = draw.box;
    const int u0 = f.x_major ? b.x0 : b.y0, u1 = f.x_major ? b.x1 : b.y1, v0 = f.x_major ? b.y0 : b.x0,
              v1 = f.x_major ? b.y1 : b.x1;
    const std::int64_t du = u[1] - u[0], dv = v[1] - v[0], row = f.length << s;
    for (int i = u0; i < u1; ++i) {
        const std::int64_t p = (std::int64_t{u_tile + i} << s) + (std::int64_t{1} << (s - 1));
        if (du > 0 ? p < u[0] || p >= u[1] : p > u[0] || p <= u[1]) continue;
        const std::int64_t top = v[0] * f.length + (du > 0 ? dv : -dv) * (p - u[0]) - (width - 1) * row / 2;
        const std::int64_t first = (top >= 0 ? top / row : -((-top + row - 1) / row)) - v_tile;
        for (std::int64_t j = std::max<std::int64_t>(first, v0);
             j < std::min<std::int64_t>(first + width, v1); ++j)
            f.x_major ? out.add(i, int(j)) : out.add(int(j), i);
    }
}

inline void point_pixels(const TileDraw& draw, const PrimitiveFrame& f, int size, PixelSet& out) {
    const std::int64_t shift = (size - 1) * (std::int64_t{1} << (f.s - 1));
    const std::int64_t x = ((f.x[0] - shift) >> f.s) - draw.tile.x,
                       y = ((f.y[0] - shift) >> f.s) - draw.tile.y;
    const BlockBox& b = draw.box;
    for (std::int64_t j = std::max<std::int64_t>(y, b.y0); j < std::min<std::int64_t>(y + size, b.y1); ++j)
        for (std::int64_t i = std::max<std::int64_t>(x, b.x0); i < std::min<std::int64_t>(x + size, b.x1);
             ++i)
            out.add(int(i), int(j));
}

template <class Visit>
inline void visit_line_or_point(const TileDraw& draw, const PrimitiveFrame& frame, const Visit& visit) {
    PixelSet pixels;
    pixels.blocks_per_row = draw.tile.side / block_side;
    const State& s = draw.op->state.state;
    if (frame.kind == MeshKind::Lines)
        line_pixels(draw, frame, s.line_width, pixels);
    else
        point_pixels(draw, frame, s.point_size, pixels);
    for (int block = 0; block < pixels.blocks_per_row * pixels.blocks_per_row; ++block)
        if (pixels.mask[block] != 0)
            visit(block % pixels.blocks_per_row, block / pixels.blocks_per_row, pixels.mask[block]);
}

/// Calls visit(bx, by, mask) for every covered block of a primitive.
template <class Visit>
HWY_INLINE void visit_primitive(const TileDraw& draw, const PrimitiveFrame& frame, const Visit& visit) {
    if (frame.kind == MeshKind::Triangles)
        visit_triangle(draw, frame, visit);
    else
        visit_line_or_point(draw, frame, visit);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
