// Which pixels of a tile a triangle, line or point covers, a block at a time. docs/manual.md, "Coverage";
// scalar twin: gw/reference/triangle.cpp. Does not interpolate or test.
// Included once per Highway target.
#if defined(GW_FAST_COVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COVER_INL_H_
#undef GW_FAST_COVER_INL_H_
#else
#define GW_FAST_COVER_INL_H_
#endif

#include "gw/fast/triangles-inl.h"
#include "gw/fast/walk-inl.h"

#include <algorithm>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// A triangle's edge functions, moving with the blocks.
struct EdgeWalk {
    Linear edge[3];

    HWY_INLINE void start(const TileEdges& e, int bx, int by) {
        for (std::size_t k = 0; k < 3; ++k)
            edge[k].start(std::uint32_t(e.c[k]), std::uint32_t(e.a[k]), std::uint32_t(e.b[k]), bx, by);
    }
    HWY_INLINE void next_block() {
        for (Linear& e : edge) e.next_block();
    }
    HWY_INLINE void next_row() {
        for (Linear& e : edge) e.next_row();
    }
    /// Lanes whose centres are inside all three edges: no sign bit is set.
    HWY_INLINE LaneSet covered() const {
        const I32 d;
        LaneSet s;
        for (std::size_t i = 0; i < parts; ++i) {
            const auto any = hn::Or(hn::Or(edge[0].at[i], edge[1].at[i]), edge[2].at[i]);
            s.part[i] = hn::RebindMask(D32(), hn::Not(hn::Lt(hn::BitCast(d, any), hn::Zero(d))));
        }
        return s;
    }
};

/// How a triangle covers a rectangle of pixels, as far as its edges tell.
enum class Extent { Outside, Partial, Inside };

/// Blocks [x0, x1] x [y0, y1] of a tile.
struct BlockRange {
    int x0, y0, x1, y1;
};

HWY_INLINE Extent extent_of(const TileEdges& e, const BlockRange& blocks) {
    const int x0 = blocks.x0 * block_side, x1 = blocks.x1 * block_side + block_side - 1;
    const int y0 = blocks.y0 * block_side, y1 = blocks.y1 * block_side + block_side - 1;
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

/// Lanes of the box in one block; all, where the box is the whole tile.
struct BoxLanes {
    const BlockBox& box;
    bool whole;

    HWY_INLINE explicit BoxLanes(const TileDraw& draw)
        : box(draw.box),
          whole(box.x0 == 0 && box.y0 == 0 && box.x1 == draw.tile.side && box.y1 == draw.tile.side) {}
    HWY_INLINE void cut(int bx, int by, LaneSet& s) const {
        if (whole) return;
        const LaneSet inside = lane_set(box.mask(bx, by));
        for (std::size_t i = 0; i < parts; ++i) s.part[i] = hn::And(s.part[i], inside.part[i]);
    }
};

/// Blocks that the triangle covers wholly; without a box to cut them the visitor may be told so.
template <class Walk, class Visit>
HWY_INLINE void visit_full_blocks(const BoxLanes& box, const BlockRange& r, Walk& walk, const Visit& visit) {
    if constexpr (std::is_invocable_v<Visit, int, int, AllLanes>) {
        if (box.whole) {
            for (int by = r.y0; by <= r.y1; ++by, walk.next_row())
                for (int bx = r.x0; bx <= r.x1; ++bx, walk.next_block()) visit(bx, by, AllLanes{});
            return;
        }
    }
    for (int by = r.y0; by <= r.y1; ++by, walk.next_row())
        for (int bx = r.x0; bx <= r.x1; ++bx, walk.next_block()) {
            LaneSet lanes = lane_set(all_lanes);
            box.cut(bx, by, lanes);
            if (!lanes.none()) visit(bx, by, lanes);
        }
}

template <class Walk, class Visit>
HWY_INLINE void visit_covered_blocks(const BoxLanes& box, const TileEdges& edges, const BlockRange& r,
                                     Walk& walk, const Visit& visit) {
    EdgeWalk edge;
    edge.start(edges, r.x0, r.y0);
    for (int by = r.y0; by <= r.y1; ++by, edge.next_row(), walk.next_row())
        for (int bx = r.x0; bx <= r.x1; ++bx, edge.next_block(), walk.next_block()) {
            LaneSet lanes = edge.covered();
            box.cut(bx, by, lanes);
            if (!lanes.none()) visit(bx, by, lanes);
        }
}

/// Calls visit(bx, by, lanes) for every covered block of one of the triangles; `walk` stands at that block.
template <class Walk, class Visit>
HWY_INLINE void visit_triangle(const BoxLanes& box, const Triangles& t, std::size_t i, Walk& walk,
                               const Visit& visit) {
    const TileEdges edges = t.edges(i);
    const BlockRange all{t.x0[i] / block_side, t.y0[i] / block_side, (t.x1[i] - 1) / block_side,
                         (t.y1[i] - 1) / block_side};
    if (all.x1 - all.x0 < group_blocks && all.y1 - all.y0 < group_blocks) {
        walk.start(all.x0, all.y0);
        return visit_covered_blocks(box, edges, all, walk, visit);
    }
    if (extent_of(edges, all) == Extent::Inside) {
        walk.start(all.x0, all.y0);
        return visit_full_blocks(box, all, walk, visit);
    }
    for (int y = all.y0; y <= all.y1; y += group_blocks)
        for (int x = all.x0; x <= all.x1; x += group_blocks) {
            const BlockRange group{x, y, std::min(x + group_blocks - 1, all.x1),
                                   std::min(y + group_blocks - 1, all.y1)};
            const Extent extent = extent_of(edges, group);
            if (extent == Extent::Outside) continue;
            walk.start(x, y);
            extent == Extent::Inside ? visit_full_blocks(box, group, walk, visit)
                                     : visit_covered_blocks(box, edges, group, walk, visit);
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
            visit(block % pixels.blocks_per_row, block / pixels.blocks_per_row, lane_set(pixels.mask[block]));
}

/// Hands on a bin in its order: triangles in batches, lines and points one by one.
template <class Batch, class Single>
HWY_INLINE void walk_bin(const TileDraw& draw, std::span<const std::uint32_t> bin, const Batch& triangles,
                         const Single& other) {
    const std::uint32_t triangles_end = draw.op->set->triangle_count;
    while (!bin.empty()) {
        std::size_t n = 0;
        while (n < std::min(bin.size(), batch_room) && bin[n] < triangles_end) ++n;
        n == 0 ? other(bin[0]) : triangles(bin.first(n));
        bin = bin.subspan(std::max<std::size_t>(n, 1));
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
