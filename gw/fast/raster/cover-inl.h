// Finds the pixels of a tile that a triangle covers, a block at a time. docs/manual.md, "Coverage";
// scalar twin: gw/reference/coverage.cpp. Does not interpolate or test.
// Included once per Highway target.
#if defined(GW_FAST_COVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COVER_INL_H_
#undef GW_FAST_COVER_INL_H_
#else
#define GW_FAST_COVER_INL_H_
#endif

#include "gw/base/prefetch.h"
#include "gw/fast/raster/triangles-inl.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/stages/stipple.h"

#include <algorithm>
#include <bit>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Edge functions at the lowest pixels of 4x4 squares.
struct SquareEdges {
    alignas(64) std::uint32_t at[3][block_pixels];
};

/// A triangle's edge functions, moving with the blocks.
struct EdgeWalk {
    Linear edge[3];

    HWY_INLINE void aim(const TileEdges& e) {
        for (std::size_t k = 0; k < 3; ++k)
            edge[k].aim(std::uint32_t(e.c[k]), std::uint32_t(e.a[k]), std::uint32_t(e.b[k]));
    }
    HWY_INLINE void start_rows(int bx, int by) {
        for (Linear& e : edge) e.start_rows(bx, by);
    }
    HWY_INLINE void next_block() {
        for (Linear& e : edge) e.next_block();
    }
    HWY_INLINE void next_row() {
        for (Linear& e : edge) e.next_row();
    }
    /// Lanes whose centres are inside all three edges.
    HWY_INLINE LaneSet covered() const {
        return inside([&](std::size_t k, std::size_t part) { return edge[k].at(part); });
    }
    /// Coverage of any block, from edge values at its corner.
    HWY_INLINE LaneSet covered(const SquareEdges& blocks, std::size_t block) const {
        return inside([&](std::size_t k, std::size_t part) {
            return edge[k].lanes.above(blocks.at[k][block], part);
        });
    }

private:
    /// No sign bit is set.
    HWY_INLINE static LaneSet inside(const auto& value) {
        const I32 d;
        LaneSet s;
        for (std::size_t i = 0; i < parts; ++i) {
            const auto any = hn::Or(hn::Or(value(0, i), value(1, i)), value(2, i));
            s.part[i] = hn::RebindMask(D32(), hn::Not(hn::Lt(hn::BitCast(d, any), hn::Zero(d))));
        }
        return s;
    }
};

/// Blocks [x0, x1] x [y0, y1] of a tile.
struct BlockRange {
    int x0, y0, x1, y1;

    /// The range of the blocks that triangle i may touch.
    HWY_INLINE static BlockRange of(const Triangles& t, std::size_t i) {
        return {t.x0[i] / block_side, t.y0[i] / block_side, (t.x1[i] - 1) / block_side,
                (t.y1[i] - 1) / block_side};
    }
    HWY_INLINE BlockRange with(const BlockRange& o) const {
        return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
    }
    /// Whether it is no larger than a group.
    HWY_INLINE bool is_small() const { return x1 - x0 < group_blocks && y1 - y0 < group_blocks; }
    /// The squares that touch the range, of 4x4 squares of `step` blocks from block (x, y) on.
    /// Precondition: one touches it, and x and y are multiples of `step`.
    HWY_INLINE std::uint32_t squares(int x, int y, int step) const {
        const auto least = [&](int low, int from) { return std::max((low - from) / step, 0); };
        const auto most = [&](int high, int from) { return std::min((high - from) / step, 3); };
        const std::uint32_t columns = 0xFu << least(x0, x) & 0xFu >> (3 - most(x1, x)),
                            rows = 0xFFFFu << 4 * least(y0, y) & 0xFFFFu >> 4 * (3 - most(y1, y));
        return columns * 0x1111u & rows;
    }
};

/// Of 4x4 squares, those that lie outside an edge, and those that lie inside all edges.
struct Extents {
    std::uint32_t outside, inside;
};

/// Squares of `side` pixels, the first with its lowest pixel at (x, y) of the tile.
HWY_INLINE Extents extents_of(const TileEdges& e, int x, int y, int side, SquareEdges& edges) {
    const I32 d;
    Extents out{0, 0};
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto at = [&](const std::uint32_t* lane, int first) {
            const auto steps = hn::BitCast(d, hn::Load(D32(), lane + i));
            return hn::Add(hn::Mul(steps, hn::Set(d, side)), hn::Set(d, first));
        };
        const auto px = at(lane_x, x), py = at(lane_y, y);
        // sign bits: an edge has all pixels outside; an edge has a pixel outside
        auto most = hn::Zero(d), least = hn::Zero(d);
        for (std::size_t k = 0; k < 3; ++k) {
            const int across = e.a[k] * (side - 1), along = e.b[k] * (side - 1);
            const auto corner =
                hn::Add(hn::Add(hn::Mul(hn::Set(d, e.a[k]), px), hn::Mul(hn::Set(d, e.b[k]), py)),
                        hn::Set(d, e.c[k]));
            hn::Store(hn::BitCast(D32(), corner), D32(), edges.at[k] + i);
            most =
                hn::Or(most, hn::Add(corner, hn::Set(d, std::max(across, 0) + std::max(along, 0))));
            least = hn::Or(least,
                           hn::Add(corner, hn::Set(d, std::min(across, 0) + std::min(along, 0))));
        }
        const auto negative = [&](auto v) {
            return bits_of(d, hn::Lt(v, hn::Zero(d)), lanes32) << i;
        };
        out.outside |= negative(most);
        out.inside |= negative(least);
    }
    out.inside ^= all_lanes;
    return out;
}

/// Lanes of the box in one block; all lanes if the box is the whole tile.
struct BoxLanes {
    const BlockBox& box;
    bool whole;

    HWY_INLINE explicit BoxLanes(const TileDraw& draw)
        : box(draw.box), whole(box.whole(draw.tile)) {}
    /// Whether the 4x4 blocks from (x, y) on are wholly in the box.
    HWY_INLINE bool has_group(int x, int y) const {
        const int side = group_blocks * block_side;
        return whole || (box.x0 <= x * block_side && x * block_side + side <= box.x1 &&
                         box.y0 <= y * block_side && y * block_side + side <= box.y1);
    }
    HWY_INLINE std::uint32_t mask(int bx, int by) const {
        return whole ? all_lanes : box.mask(bx, by);
    }
    HWY_INLINE void cut(int bx, int by, LaneSet& s) const {
        if (whole) return;
        const LaneSet inside = lane_set(box.mask(bx, by));
        for (std::size_t i = 0; i < parts; ++i) s.part[i] = hn::And(s.part[i], inside.part[i]);
    }
};

/// The lanes of a block that the polygon stipple leaves.
HWY_INLINE LaneSet stippled(const TileDraw& draw, int bx, int by, const LaneSet& lanes) {
    const auto& pattern = draw.op->state.state.polygon_stipple.pattern;
    if (!pattern) return lanes;
    std::uint32_t left = lanes.bits();
    for (std::uint32_t rest = left; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        const int x = draw.tile.x + bx * block_side + lane % block_side,
                  y = draw.tile.y + by * block_side + lane / block_side;
        if (!stipple_bit(*pattern, x, y)) left &= ~(1u << lane);
    }
    return lane_set(left);
}

/// Visits a block that the triangle covers wholly. If no box cuts it, a visitor may take AllLanes.
template <class Visit>
HWY_INLINE void visit_full_block(const BoxLanes& box, int bx, int by, const Visit& visit) {
    if constexpr (std::is_invocable_v<Visit, int, int, AllLanes>) {
        if (box.whole) return visit(bx, by, AllLanes{});
    }
    LaneSet lanes = lane_set(all_lanes);
    box.cut(bx, by, lanes);
    if (!lanes.none()) visit(bx, by, lanes);
}

template <class Walk, class Visit>
HWY_INLINE void visit_full_blocks(const BoxLanes& box, const BlockRange& r, Walk& walk,
                                  const Visit& visit) {
    walk.start_rows(r.x0, r.y0);
    for (int by = r.y0; by <= r.y1; ++by, walk.next_row())
        for (int bx = r.x0; bx <= r.x1; ++bx, walk.next_block())
            visit_full_block(box, bx, by, visit);
}

/// A visitor that takes whole blocks in groups: a mask of the 4x4 blocks from (x, y) on.
template <class Visit>
concept TakesGroups = requires(const Visit& visit) {
    visit.whole_blocks(0, 0, 0u);
};

/// Visits a group that the triangle covers wholly.
template <class Walk, class Visit>
HWY_INLINE void visit_full_group(const BoxLanes& box, int x, int y, Walk& walk,
                                 const Visit& visit) {
    if constexpr (TakesGroups<Visit>) {
        if (box.has_group(x, y)) return visit.whole_blocks(x, y, all_lanes);
    }
    visit_full_blocks(box, {x, y, x + group_blocks - 1, y + group_blocks - 1}, walk, visit);
}

/// A visitor that a block without lanes costs less than a branch, which is hard to predict.
template <class Visit>
concept TakesNoLanes = Visit::takes_no_lanes;

/// Visits every block of a small range.
template <class Walk, class Visit>
HWY_INLINE void visit_covered_blocks(const BoxLanes& box, EdgeWalk& edge, const BlockRange& r,
                                     Walk& walk, const Visit& visit) {
    edge.start_rows(r.x0, r.y0);
    walk.start_rows(r.x0, r.y0);
    for (int by = r.y0; by <= r.y1; ++by, edge.next_row(), walk.next_row())
        for (int bx = r.x0; bx <= r.x1; ++bx, edge.next_block(), walk.next_block()) {
            LaneSet lanes = edge.covered();
            box.cut(bx, by, lanes);
            if (TakesNoLanes<Visit> || !lanes.none()) visit(bx, by, lanes);
        }
}

/// Visits those `blocks` of a group, one bit each, that the triangle may touch.
template <class Walk, class Visit>
HWY_INLINE void visit_blocks(const BoxLanes& box, const EdgeWalk& edge, const SquareEdges& edges,
                             int x, int y, std::uint32_t blocks, std::uint32_t full, Walk& walk,
                             const Visit& visit) {
    if constexpr (TakesGroups<Visit>) {
        if ((blocks & full) != 0 && box.has_group(x, y)) {
            visit.whole_blocks(x, y, blocks & full);
            blocks &= ~full;
        }
    }
    for (; blocks != 0; blocks &= blocks - 1) {
        const int i = std::countr_zero(blocks), bx = x + i % group_blocks,
                  by = y + i / group_blocks;
        if (full >> i & 1) {
            walk.start(bx, by);
            visit_full_block(box, bx, by, visit);
            continue;
        }
        LaneSet lanes = edge.covered(edges, std::size_t(i));
        box.cut(bx, by, lanes);
        if (lanes.none()) continue;
        walk.start(bx, by);
        visit(bx, by, lanes);
    }
}

/// Visits blocks in groups of 4x4, so that a large triangle's empty and full parts cost almost
/// nothing. First the groups are sorted into untouched, covered and crossed.
template <class Walk, class Visit>
HWY_INLINE void visit_groups(const BoxLanes& box, const TileEdges& edges, EdgeWalk& edge,
                             const BlockRange& all, Walk& walk, const Visit& visit) {
    constexpr int group_side = group_blocks * block_side;
    SquareEdges squares;
    const Extents groups = extents_of(edges, 0, 0, group_side, squares);
    const std::uint32_t touched = all.squares(0, 0, group_blocks) & ~groups.outside;
    if constexpr (!TakesGroups<Visit>) {
        if ((touched & ~groups.inside) == 0 && touched == all.squares(0, 0, group_blocks))
            return visit_full_blocks(box, all, walk, visit);
    }
    for (std::uint32_t rest = touched; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest), x = i % 4 * group_blocks, y = i / 4 * group_blocks;
        if (groups.inside >> i & 1) {
            visit_full_group(box, x, y, walk, visit);
            continue;
        }
        const Extents blocks =
            extents_of(edges, x * block_side, y * block_side, block_side, squares);
        visit_blocks(box, edge, squares, x, y, all.squares(x, y, 1) & ~blocks.outside,
                     blocks.inside, walk, visit);
    }
}

/// Visitors of the covered blocks of one triangle: visit(bx, by, lanes), with `walk` at that block.
struct SmallTriangle {
    /// A triangle on at most 2x2 blocks, whose lanes are known.
    template <class Walk, class Visit>
    HWY_INLINE static void visit(const BoxLanes& box, const Triangles& t, std::size_t i, Walk& walk,
                                 const Visit& visit) {
        const int x = t.x0[i] / block_side, y = t.y0[i] / block_side;
        walk.aim();
        for (std::uint64_t rest = t.small_lanes(i); rest != 0;) {
            const int first = std::countr_zero(rest) & ~15, block = first / block_pixels;
            const int bx = x + block % 2, by = y + block / 2;
            const std::uint32_t lanes = std::uint32_t(rest >> first) & box.mask(bx, by);
            rest &= ~(std::uint64_t{all_lanes} << first);
            if (lanes == 0) continue;
            walk.start(bx, by);
            visit(bx, by, lane_set(lanes));
        }
    }
};
struct LargeTriangle {
    template <class Walk, class Visit>
    HWY_INLINE static void visit(const BoxLanes& box, const Triangles& t, std::size_t i, Walk& walk,
                                 const Visit& visit) {
        const TileEdges edges = t.edges(i);
        const BlockRange all = BlockRange::of(t, i);
        EdgeWalk edge;
        edge.aim(edges);
        walk.aim();
        if (all.is_small())
            visit_covered_blocks(box, edge, all, walk, visit);
        else
            visit_groups(box, edges, edge, all, walk, visit);
    }
};

/// Calls draw(size) with the visitor of triangle i.
template <class Draw>
HWY_INLINE void by_size(const Triangles& t, std::size_t i, const Draw& draw) {
    if (t.is_small(i))
        draw(SmallTriangle{});
    else
        draw(LargeTriangle{});
}

/// Prefetches the primitives of the batch after the next, and the vertices of the next batch. Those
/// of one mesh of triangles are close together anyhow; points may lie anywhere.
HWY_INLINE void prefetch_batches(const DrawOp& op, std::span<const std::uint32_t> bin) {
    const GeometrySet& set = *op.set;
    if (set.parts.size() == 1 && set.triangle_count != 0) return;
    const auto end_of = [&](std::size_t batches) {
        return std::min(bin.size(), batches * batch_capacity);
    };
    for (std::size_t i = end_of(2); i < end_of(3); ++i) prefetch(&set.primitives[bin[i]], 1);
    for (std::size_t i = end_of(1); i < end_of(2); ++i) {
        const SetupPrimitive& p = set.primitives[bin[i]];
        for (const std::uint32_t vertex : p.vertex) prefetch(&set.at[vertex], 1);
        if (op.colors) prefetch(&op.colors->of(p)[p.provoking], 1);
    }
}

/// Visits a bin in order, in batches of triangles and of lines and points.
template <class Batch, class Others>
HWY_INLINE void walk_bin(const TileDraw& draw, std::span<const std::uint32_t> bin,
                         const Batch& triangles, const Others& others) {
    const GeometrySet& set = *draw.op->set;
    const auto is_triangle = [&](std::uint32_t i) {
        return i < set.triangle_count || set.primitives[i].kind == MeshKind::Triangles;
    };
    while (!bin.empty()) {
        prefetch_batches(*draw.op, bin);
        const bool are_triangles = is_triangle(bin[0]);
        std::size_t n = 1;
        while (n < std::min(bin.size(), batch_capacity) && is_triangle(bin[n]) == are_triangles)
            ++n;
        if (are_triangles)
            triangles(bin.first(n));
        else
            others(bin.first(n));
        bin = bin.subspan(n);
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
