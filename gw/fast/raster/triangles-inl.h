// Set-up of up to 16 triangles of a tile: edges, pixel boxes, depth planes, and the coverage of
// small ones. docs/manual.md, "Coverage", "Planes"; scalar twin: gw/fast/raster/setup.cpp.
// Does not rasterize. Included once per Highway target.
#if defined(GW_FAST_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TRIANGLES_INL_H_
#undef GW_FAST_TRIANGLES_INL_H_
#else
#define GW_FAST_TRIANGLES_INL_H_
#endif

#include "gw/fast/raster/corners-inl.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/stages/polygon_offset.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Triangles in the order of their bin. Pixels [x0, x1) x [y0, y1) of the tile may be covered.
struct Triangles {
    Corners corners;
    /// as in TileEdges
    alignas(64) std::int32_t c[3][batch_capacity], a[3][batch_capacity], b[3][batch_capacity];
    alignas(64) std::int32_t x0[batch_capacity], y0[batch_capacity], x1[batch_capacity],
        y1[batch_capacity];
    PlaneBatch depth;
    /// Triangles that touch at most 2x2 blocks, a bit each, and the lanes that they cover. Bits 0
    /// to 15 are the left block's, bits 16 to 31 the right one's.
    std::uint32_t small = 0;
    alignas(64) std::uint32_t lower[batch_capacity], upper[batch_capacity];

    std::size_t count() const { return corners.count; }
    TileEdges edges(std::size_t i) const {
        return {
            {c[0][i], c[1][i], c[2][i]}, {a[0][i], a[1][i], a[2][i]}, {b[0][i], b[1][i], b[2][i]}};
    }
    bool empty(std::size_t i) const { return x0[i] >= x1[i] || y0[i] >= y1[i]; }
    bool is_small(std::size_t i) const { return (small >> i & 1) != 0; }
    std::uint64_t small_lanes(std::size_t i) const {
        return std::uint64_t{upper[i]} << 32 | lower[i];
    }
};

/// The depth plane of one lane.
HWY_INLINE DepthPlane depth_of(const TileDraw& draw, const Triangles& t, std::size_t i) {
    if (t.depth.sure >> i & 1) return {t.depth.at(i), 0};
    return depth_plane(draw, *t.corners.primitive[i], frame_of(draw, t.corners.ordinal[i]));
}

/// First and one past the last pixel whose centre lies in a triangle's extent along one axis.
HWY_INLINE void pixel_extents(const std::int32_t (&at)[3][batch_capacity], std::size_t filled,
                              int s, int tile, int low, int high, std::int32_t* first,
                              std::int32_t* end) {
    const hn::CappedTag<std::int32_t, batch_capacity / 2> d;
    const auto half = hn::Set(d, 1 << (s - 1)), to = hn::Set(d, tile), one = hn::Set(d, 1);
    const auto in_box = [&](auto v) {
        return hn::Max(hn::Set(d, low), hn::Min(v, hn::Set(d, high)));
    };
    for (std::size_t i = 0; i < filled; i += hn::Lanes(d)) {
        const auto p0 = hn::Load(d, at[0] + i), p1 = hn::Load(d, at[1] + i),
                   p2 = hn::Load(d, at[2] + i);
        const auto least = hn::Min(hn::Min(p0, p1), p2), most = hn::Max(hn::Max(p0, p1), p2);
        const auto from = hn::ShiftRightSame(hn::Add(least, hn::Sub(half, one)), s);
        const auto last = hn::ShiftRightSame(hn::Sub(most, half), s);
        hn::Store(in_box(hn::Sub(from, to)), d, first + i);
        hn::Store(in_box(hn::Sub(hn::Add(last, one), to)), d, end + i);
    }
}

#if HWY_HAVE_FLOAT64

/// tile_edges() of gw/fast/raster/setup.h: products below 2^46.
HWY_INLINE void set_up_edges(const TileDraw& draw, Triangles& t, std::size_t first) {
    const I32ForD64 i32;
    const int s = t.corners.s;
    const auto zero = hn::Zero(D64()), limit = all(1073741824.0), scale = all(1.0 / double(1 << s));
    const auto px = all(double((draw.tile.x << s) + (1 << (s - 1)))),
               py = all(double((draw.tile.y << s) + (1 << (s - 1))));
    V64 x[3], y[3];
    for (std::size_t k = 0; k < 3; ++k) {
        x[k] = load_integers(t.corners.x[k] + first);
        y[k] = load_integers(t.corners.y[k] + first);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t j = (k + 1) % 3;
        const auto dx = hn::Sub(x[j], x[k]), dy = hn::Sub(y[j], y[k]);
        const auto top_left = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Lt(dx, zero)));
        const auto at_tile =
            hn::Sub(hn::Mul(dx, hn::Sub(py, y[k])), hn::Mul(dy, hn::Sub(px, x[k])));
        const auto biased = hn::Sub(at_tile, hn::IfThenZeroElse(top_left, all(1)));
        const auto c =
            hn::Max(hn::Sub(zero, limit), hn::Min(hn::Floor(hn::Mul(biased, scale)), limit));
        hn::Store(hn::DemoteTo(i32, c), i32, t.c[k] + first);
        hn::Store(hn::DemoteTo(i32, hn::Sub(zero, dy)), i32, t.a[k] + first);
        hn::Store(hn::DemoteTo(i32, dx), i32, t.b[k] + first);
    }
}

HWY_INLINE void set_up_edges(const TileDraw& draw, Triangles& t) {
    for (std::size_t i = 0; i < t.count(); i += hn::Lanes(D64())) set_up_edges(draw, t, i);
}

/// Depth planes of triangles that have one depth each, as of walls parallel to the window.
HWY_INLINE void set_up_level_depths(Triangles& t) {
    const I64ForD64 d;
    for (std::size_t i = 0; i < t.corners.filled; i += hn::Lanes(d)) {
        const auto z = hn::PromoteTo(U64ForD64(), hn::Load(U32ForD64(), t.corners.z[0] + i));
        hn::Store(hn::Add(hn::ShiftLeft<16>(hn::BitCast(d, z)), hn::Set(d, 1 << 15)), d,
                  t.depth.c + i);
        hn::Store(hn::Zero(d), d, t.depth.gx + i);
        hn::Store(hn::Zero(d), d, t.depth.gy + i);
    }
    t.depth.sure = all_lanes;
}

HWY_INLINE void set_up_depths(Triangles& t) {
    if (all_level(t.corners)) return set_up_level_depths(t);
    set_up_planes(
        t.corners, [&](std::size_t k, std::size_t i) { return load_unsigned(t.corners.z[k] + i); },
        t.depth);
}

/// Whether all depths of triangle i lie between its corners', widened by 1: the gradients' rounding
/// is half a unit in 2^15 pixels.
HWY_INLINE bool is_near(const Corners& t, std::size_t i) {
    return std::abs(t.to_x[i]) < 1 << 14 && std::abs(t.to_y[i]) < 1 << 14;
}

/// Adds the polygon offset to the depths of triangle i, at its corners too. Returns whether it is
/// sure that no depth in between leaves the range of the depth plane.
HWY_INLINE bool add_offset(const TileDraw& draw, Triangles& t, std::size_t i) {
    const int bits = draw.profile->depth_bits;
    const std::int64_t offset = depth_offset(draw.op->state.state.polygon_offset,
                                             offset_slope(t.depth.gx[i], t.depth.gy[i]), bits),
                       max = max_of_bits(bits);
    auto& z = t.corners.z;
    const std::int64_t low = std::min({z[0][i], z[1][i], z[2][i]}),
                       high = std::max({z[0][i], z[1][i], z[2][i]});
    const bool is_inside = low > 0 && low + offset > 0 && high < max && high + offset < max;
    if (!is_inside || !is_near(t.corners, i)) return false;
    for (std::size_t k = 0; k < 3; ++k) z[k][i] = std::uint32_t(z[k][i] + offset);
    t.depth.base[i] += offset * 65536;
    t.depth.c[i] += offset * 65536;
    return true;
}
HWY_NOINLINE inline void add_offsets(const TileDraw& draw, Triangles& t) {
    for (std::uint32_t rest = t.depth.sure & ((1u << t.count()) - 1); rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        if (!add_offset(draw, t, std::size_t(i))) t.depth.sure &= ~(1u << i);
    }
}

#else

HWY_INLINE void set_up_edges(const TileDraw& draw, Triangles& t) {
    for (std::size_t i = 0; i < t.count(); ++i) {
        const TileEdges e = tile_edges(frame_of(draw, t.corners.ordinal[i]), draw.tile);
        for (std::size_t k = 0; k < 3; ++k) {
            t.c[k][i] = e.c[k];
            t.a[k][i] = e.a[k];
            t.b[k][i] = e.b[k];
        }
    }
}

HWY_INLINE void set_up_depths(Triangles& t) { t.depth.sure = 0; }
inline void add_offsets(const TileDraw&, Triangles&) {}

#endif  // HWY_HAVE_FLOAT64

/// Triangles' edge functions at the same pixel of each one's own blocks.
struct EdgeLanes {
    using D = hn::CappedTag<std::int32_t, batch_capacity / 2>;
    hn::Vec<D> at[3], row[3], a[3], b[3];

    HWY_INLINE EdgeLanes(const Triangles& t, std::size_t first, hn::Vec<D> x, hn::Vec<D> y) {
        const D d;
        for (std::size_t k = 0; k < 3; ++k) {
            a[k] = hn::Load(d, t.a[k] + first);
            b[k] = hn::Load(d, t.b[k] + first);
            at[k] = row[k] =
                hn::Add(hn::Load(d, t.c[k] + first), hn::Add(hn::Mul(a[k], x), hn::Mul(b[k], y)));
        }
    }
    /// Shifts in whether the pixel is outside, as a word's highest bit, and steps to the next
    /// pixel.
    HWY_INLINE void shift_in(hn::Vec<D>& lanes) {
        const D d;
        const auto any = hn::Or(hn::Or(at[0], at[1]), at[2]);
        const auto shifted =
            hn::BitCast(d, hn::ShiftRight<1>(hn::BitCast(hn::RebindToUnsigned<D>(), lanes)));
        lanes = hn::Or(shifted, hn::And(any, hn::Set(d, INT32_MIN)));
        for (std::size_t k = 0; k < 3; ++k) at[k] = hn::Add(at[k], a[k]);
    }
    HWY_INLINE void next_row() {
        for (std::size_t k = 0; k < 3; ++k) at[k] = row[k] = hn::Add(row[k], b[k]);
    }
    /// The lanes inside, for two blocks side by side.
    HWY_INLINE hn::Vec<D> covered_blocks() {
        const D d;
        auto left = hn::Zero(d), right = hn::Zero(d);
        for (int y = 0; y < block_side; ++y, next_row()) {
            for (int x = 0; x < block_side; ++x) shift_in(left);
            for (int x = 0; x < block_side; ++x) shift_in(right);
        }
        const auto low = hn::ShiftRight<16>(hn::BitCast(hn::RebindToUnsigned<D>(), left));
        return hn::Not(hn::Or(hn::And(right, hn::Set(d, INT32_MIN >> 15)), hn::BitCast(d, low)));
    }
};

/// Finds the small triangles and the pixels that they cover, a vector of triangles at a time.
HWY_INLINE void cover_small(Triangles& t) {
    const EdgeLanes::D d;
    const hn::RebindToUnsigned<EdgeLanes::D> u;
    const auto one = hn::Set(d, 1), two = hn::Set(d, 2), left_block = hn::Set(d, 0xFFFF);
    t.small = 0;
    for (std::size_t i = 0; i < t.corners.filled; i += hn::Lanes(d)) {
        const auto block = [&](const std::int32_t* p) {
            return hn::ShiftRight<2>(hn::Load(d, p + i));
        };
        const auto last = [&](const std::int32_t* p) {
            return hn::ShiftRight<2>(hn::Sub(hn::Load(d, p + i), one));
        };
        const auto x = block(t.x0), y = block(t.y0);
        const auto columns = hn::Sub(last(t.x1), x), rows = hn::Sub(last(t.y1), y);
        const auto small = hn::And(hn::Lt(columns, two), hn::Lt(rows, two));
        if (hn::AllFalse(d, small)) continue;
        t.small |= bits_of(d, small, hn::Lanes(d)) << i;
        EdgeLanes edges(t, i, hn::ShiftLeft<2>(x), hn::ShiftLeft<2>(y));
        // Blocks past the last one lie outside the tile.
        const auto inside = hn::IfThenElse(hn::Lt(columns, one), left_block, hn::Set(d, -1));
        const auto lower = hn::And(edges.covered_blocks(), inside), upper = edges.covered_blocks();
        hn::Store(hn::BitCast(u, lower), u, t.lower + i);
        hn::Store(hn::BitCast(u, hn::IfThenZeroElse(hn::Lt(rows, one), hn::And(upper, inside))), u,
                  t.upper + i);
    }
}

/// Sets up the first triangles of a bin, up to batch_capacity, with depth planes if asked. `shift`
/// is added to the jitter.
inline void set_up_triangles(const TileDraw& draw, std::span<const std::uint32_t> bin, bool depth,
                             Triangles& t, const JitterState& shift = {}) {
    gather_corners(draw, bin, t.corners, shift);
    const int s = t.corners.s;
    pixel_extents(t.corners.x, t.corners.filled, s, draw.tile.x, draw.box.x0, draw.box.x1, t.x0,
                  t.x1);
    pixel_extents(t.corners.y, t.corners.filled, s, draw.tile.y, draw.box.y0, draw.box.y1, t.y0,
                  t.y1);
    set_up_edges(draw, t);
    cover_small(t);
    t.depth.sure = 0;
    if (!depth) return;
    set_up_depths(t);
    if (draw.op->state.state.polygon_offset.enable) add_offsets(draw, t);
}

/// Whether the depth planes of a batch have the polygon offset in them, if the draw has one.
HWY_INLINE bool includes_offsets(const TileDraw& draw, const Triangles& t) {
    const std::uint32_t all = (1u << t.count()) - 1;
    return !needs_depth(*draw.op) || !draw.op->state.state.polygon_offset.enable ||
           (t.depth.sure & all) == all;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
