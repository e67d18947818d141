// Set-up of up to 16 triangles of a tile at once: edges, pixel boxes, depth planes. docs/manual.md,
// "Coverage", "Planes"; scalar twin: gw/fast/setup.cpp. Doubles hold integers here: where one could need more
// than 52 bits, that triangle goes the scalar way. Does not rasterize. Included once per Highway target.
#if defined(GW_FAST_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TRIANGLES_INL_H_
#undef GW_FAST_TRIANGLES_INL_H_
#else
#define GW_FAST_TRIANGLES_INL_H_
#endif

#include "gw/fast/doubles-inl.h"
#include "gw/fast/primitive.h"

#include <algorithm>
#include <bit>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Triangles in the order of their bin, a lane each. Pixels [x0, x1) x [y0, y1) of the tile may be covered.
struct Triangles {
    static constexpr std::size_t room = 16;
    std::size_t count = 0;
    const std::uint32_t* ordinal = nullptr;
    alignas(64) std::int32_t x[3][room], y[3][room];  ///< jittered
    alignas(64) std::uint32_t z[3][room];
    alignas(64) std::int32_t c[3][room], a[3][room], b[3][room];  ///< edges, as in TileEdges
    alignas(64) std::int32_t x0[room], y0[room], x1[room], y1[room];
    alignas(64) std::int64_t depth_c[room], depth_gx[room], depth_gy[room];  ///< as in TilePlane
    std::uint32_t scalar_depth = 0;  ///< lanes whose depth plane is the scalar twin's

    TileEdges edges(std::size_t i) const {
        return {{c[0][i], c[1][i], c[2][i]}, {a[0][i], a[1][i], a[2][i]}, {b[0][i], b[1][i], b[2][i]}};
    }
    bool empty(std::size_t i) const { return x0[i] >= x1[i] || y0[i] >= y1[i]; }
};

HWY_INLINE PrimitiveFrame frame_of(const TileDraw& draw, std::uint32_t ordinal) {
    const GeometrySet& set = *draw.op->set;
    return primitive_frame(set, set.primitives[ordinal], draw.op->state.state.jitter,
                           draw.profile->subpixel_bits, draw.tile);
}

/// The depth plane of one lane.
HWY_INLINE DepthPlane depth_of(const TileDraw& draw, const Triangles& t, std::size_t i) {
    if (t.scalar_depth >> i & 1)
        return depth_plane(draw, draw.op->set->primitives[t.ordinal[i]], frame_of(draw, t.ordinal[i]));
    return {{std::uint64_t(t.depth_c[i]), t.depth_gx[i], t.depth_gy[i]}, 0};
}

HWY_INLINE void gather_corners(const TileDraw& draw, Triangles& t) {
    const GeometrySet& set = *draw.op->set;
    const JitterState& jitter = draw.op->state.state.jitter;
    for (std::size_t i = 0; i < Triangles::room; ++i) {
        const auto& vertex = set.primitives[t.ordinal[i < t.count ? i : 0]].vertex;
        for (std::size_t k = 0; k < 3; ++k) {
            t.x[k][i] = set.x[vertex[k]] + jitter.x, t.y[k][i] = set.y[vertex[k]] + jitter.y;
            t.z[k][i] = set.z[vertex[k]];
        }
    }
}

/// First and one past the last pixel whose centre lies in a triangle's extent along one axis.
HWY_INLINE void pixel_extents(const std::int32_t (&at)[3][Triangles::room], int s, int tile, int low,
                              int high, std::int32_t* first, std::int32_t* end) {
    const hn::CappedTag<std::int32_t, 16> d;
    const auto half = hn::Set(d, 1 << (s - 1)), to = hn::Set(d, tile), one = hn::Set(d, 1);
    const auto in_box = [&](auto v) { return hn::Max(hn::Set(d, low), hn::Min(v, hn::Set(d, high))); };
    for (std::size_t i = 0; i < Triangles::room; i += hn::Lanes(d)) {
        const auto p0 = hn::Load(d, at[0] + i), p1 = hn::Load(d, at[1] + i), p2 = hn::Load(d, at[2] + i);
        const auto least = hn::Min(hn::Min(p0, p1), p2), most = hn::Max(hn::Max(p0, p1), p2);
        const auto from = hn::ShiftRightSame(hn::Add(least, hn::Sub(half, one)), s);
        const auto last = hn::ShiftRightSame(hn::Sub(most, half), s);
        hn::Store(in_box(hn::Sub(from, to)), d, first + i);
        hn::Store(in_box(hn::Sub(hn::Add(last, one), to)), d, end + i);
    }
}

/// Edges and depth planes of lanes that no vector way is known for.
HWY_INLINE void set_up_scalar(const TileDraw& draw, Triangles& t) {
    for (std::size_t i = 0; i < t.count; ++i) {
        const TileEdges e = tile_edges(frame_of(draw, t.ordinal[i]), draw.tile);
        for (std::size_t k = 0; k < 3; ++k) t.c[k][i] = e.c[k], t.a[k][i] = e.a[k], t.b[k][i] = e.b[k];
    }
    t.scalar_depth = ~0u;
}

#if HWY_HAVE_FLOAT64

using I32ForD64 = hn::Rebind<std::int32_t, D64>;
using U32ForD64 = hn::Rebind<std::uint32_t, D64>;
using I64ForD64 = hn::Rebind<std::int64_t, D64>;

/// Corners of some lanes, relative to the first, and the centre of the tile's first pixel seen from it.
struct CornerLanes {
    V64 x[3], y[3];
    V64 dx1, dy1, dx2, dy2, area2;
    V64 to_x, to_y;
};

HWY_INLINE V64 load_integers(const std::int32_t* p) { return hn::PromoteTo(D64(), hn::Load(I32ForD64(), p)); }

/// Unsigned 32 bits: the conversion is signed, so the top bit goes through it as 2^31.
HWY_INLINE V64 load_depth(const std::uint32_t* p) {
    const auto flipped = hn::Xor(hn::Load(U32ForD64(), p), hn::Set(U32ForD64(), 0x80000000u));
    return hn::Add(hn::PromoteTo(D64(), hn::BitCast(I32ForD64(), flipped)), all(2147483648.0));
}

HWY_INLINE CornerLanes corner_lanes(const TileDraw& draw, const Triangles& t, std::size_t first) {
    const int s = draw.profile->subpixel_bits;
    CornerLanes l;
    for (std::size_t k = 0; k < 3; ++k)
        l.x[k] = load_integers(t.x[k] + first), l.y[k] = load_integers(t.y[k] + first);
    l.dx1 = hn::Sub(l.x[1], l.x[0]), l.dy1 = hn::Sub(l.y[1], l.y[0]);
    l.dx2 = hn::Sub(l.x[2], l.x[0]), l.dy2 = hn::Sub(l.y[2], l.y[0]);
    l.area2 = hn::Sub(hn::Mul(l.dx1, l.dy2), hn::Mul(l.dx2, l.dy1));
    const auto center = [&](int tile) { return all(double((tile << s) + (1 << (s - 1)))); };
    l.to_x = hn::Sub(center(draw.tile.x), l.x[0]), l.to_y = hn::Sub(center(draw.tile.y), l.y[0]);
    return l;
}

/// tile_edges() of gw/fast/setup.h: products below 2^46.
HWY_INLINE void set_up_edges(const TileDraw& draw, const CornerLanes& l, Triangles& t, std::size_t first) {
    const I32ForD64 i32;
    const int s = draw.profile->subpixel_bits;
    const auto zero = hn::Zero(D64()), limit = all(1073741824.0), scale = all(1.0 / double(1 << s));
    const auto px = hn::Add(l.to_x, l.x[0]), py = hn::Add(l.to_y, l.y[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t j = (k + 1) % 3;
        const auto dx = hn::Sub(l.x[j], l.x[k]), dy = hn::Sub(l.y[j], l.y[k]);
        const auto top_left = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Lt(dx, zero)));
        const auto at_tile = hn::Sub(hn::Mul(dx, hn::Sub(py, l.y[k])), hn::Mul(dy, hn::Sub(px, l.x[k])));
        const auto biased = hn::Sub(at_tile, hn::IfThenZeroElse(top_left, all(1)));
        const auto c = hn::Max(hn::Neg(limit), hn::Min(hn::Floor(hn::Mul(biased, scale)), limit));
        hn::Store(hn::DemoteTo(i32, c), i32, t.c[k] + first);
        hn::Store(hn::DemoteTo(i32, hn::Sub(zero, dy)), i32, t.a[k] + first);
        hn::Store(hn::DemoteTo(i32, dx), i32, t.b[k] + first);
    }
}

/// A gradient's lanes and those where the quotient's rounding decides nothing: |num| 2^shift < 2^51.
struct Gradient {
    V64 value;
    hn::Mask<D64> sure;
};
HWY_INLINE Gradient gradient_lanes(V64 first, V64 second, V64 area2, int shift) {
    const auto magic = all(6755399441055744.0);
    const auto small = all(2251799813685248.0 / double(std::int64_t{1} << shift));
    const auto num = hn::Sub(first, second);
    const auto q = hn::Div(hn::Mul(num, all(double(std::int64_t{1} << shift))), area2);
    const auto exact = hn::And(hn::Lt(hn::Abs(first), all(4503599627370496.0)),
                               hn::Lt(hn::Abs(second), all(4503599627370496.0)));
    return {hn::Sub(hn::Add(q, magic), magic), hn::And(exact, hn::Lt(hn::Abs(num), small))};
}

/// The plane through the values a0, a0 + d1, a0 + d2; the lanes that are exact.
HWY_INLINE std::uint32_t set_up_plane(const CornerLanes& l, V64 a0, V64 d1, V64 d2, int s, std::int64_t* c,
                                      std::int64_t* gx, std::int64_t* gy) {
    const D64 d;
    const I64ForD64 i64;
    const Gradient x = gradient_lanes(hn::Mul(d1, l.dy2), hn::Mul(d2, l.dy1), l.area2, 16 + s);
    const Gradient y = gradient_lanes(hn::Mul(d2, l.dx1), hn::Mul(d1, l.dx2), l.area2, 16 + s);
    const auto step_x = hn::Mul(x.value, l.to_x), step_y = hn::Mul(y.value, l.to_y);
    const auto step = hn::Floor(hn::Mul(hn::Add(step_x, step_y), all(1.0 / double(1 << s))));
    const auto at_tile = hn::Add(hn::Add(hn::Mul(a0, all(65536)), all(32768)), step);
    hn::Store(hn::ConvertTo(i64, at_tile), i64, c);
    hn::Store(hn::ConvertTo(i64, x.value), i64, gx);
    hn::Store(hn::ConvertTo(i64, y.value), i64, gy);
    const auto limit = all(1125899906842624.0);  // 2^50
    const auto sure = hn::And(hn::And(x.sure, y.sure),
                              hn::And(hn::Lt(hn::Abs(step_x), limit), hn::Lt(hn::Abs(step_y), limit)));
    std::uint64_t bits = 0;
    hn::StoreMaskBits(d, sure, reinterpret_cast<std::uint8_t*>(&bits));
    return std::uint32_t(bits) & ((1u << hn::Lanes(d)) - 1);
}

HWY_INLINE void set_up_lanes(const TileDraw& draw, bool depth, Triangles& t, std::size_t first) {
    const CornerLanes l = corner_lanes(draw, t, first);
    set_up_edges(draw, l, t, first);
    if (!depth) return;
    const auto z0 = load_depth(t.z[0] + first);
    const auto d1 = hn::Sub(load_depth(t.z[1] + first), z0), d2 = hn::Sub(load_depth(t.z[2] + first), z0);
    const std::uint32_t sure = set_up_plane(l, z0, d1, d2, draw.profile->subpixel_bits, t.depth_c + first,
                                            t.depth_gx + first, t.depth_gy + first);
    t.scalar_depth &= ~(sure << first);
}

#endif  // HWY_HAVE_FLOAT64

/// Sets up the first triangles of a bin, as many as there is room for; their depth planes where asked.
inline void set_up_triangles(const TileDraw& draw, std::span<const std::uint32_t> bin, bool depth,
                             Triangles& t) {
    const int s = draw.profile->subpixel_bits;
    t.count = std::min(bin.size(), Triangles::room);
    t.ordinal = bin.data();
    gather_corners(draw, t);
    pixel_extents(t.x, s, draw.tile.x, draw.box.x0, draw.box.x1, t.x0, t.x1);
    pixel_extents(t.y, s, draw.tile.y, draw.box.y0, draw.box.y1, t.y0, t.y1);
#if HWY_HAVE_FLOAT64
    t.scalar_depth = ~0u;
    const bool offset = draw.op->state.state.polygon_offset.enable;
    for (std::size_t i = 0; i < t.count; i += hn::Lanes(D64())) set_up_lanes(draw, depth && !offset, t, i);
#else
    set_up_scalar(draw, t);
#endif
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
