// Corners of up to 16 triangles, and planes through values at them, a vector of triangles at a
// time. docs/manual.md, "Planes"; scalar twin: gw/fast/raster/setup.h. The doubles here are
// integers. A plane that could need more than their bits is not `sure`, and scalar code sets up its
// triangle. Included once per Highway target.
#if defined(GW_FAST_CORNERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_CORNERS_INL_H_
#undef GW_FAST_CORNERS_INL_H_
#else
#define GW_FAST_CORNERS_INL_H_
#endif

#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/fast/raster/primitive.h"
#include "gw/fast/raster/setup.h"
#include "gw/fast/simd/doubles-inl.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/fast/vertices/geometry.h"
#include "gw/profile.h"

#include <algorithm>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE PrimitiveFrame frame_of(const TileDraw& draw, std::uint32_t ordinal) {
    const GeometrySet& set = *draw.op->set;
    const SetupPrimitive& primitive = set.primitives[ordinal];
    PrimitiveFrame frame = primitive_frame(set, primitive, draw.op->state.state.jitter,
                                           draw.profile->subpixel_bits, draw.tile);
    if (primitive.kind == MeshKind::Points) frame.point_size = point_size_of(draw, primitive);
    return frame;
}

/// A value at each corner of each triangle: out[corner][lane] = value(vertex).
template <typename T, class Value>
HWY_INLINE void gather(const Corners& t, T (&out)[3][batch_capacity], const Value& value) {
    for (std::size_t i = 0; i < t.filled; ++i)
        for (std::size_t k = 0; k < 3; ++k) out[k][i] = value(t.primitive[i]->vertex[k]);
}

HWY_INLINE void gather_positions(const TileDraw& draw, std::span<const std::uint32_t> ordinals,
                                 Corners& t, const JitterState& shift) {
    const GeometrySet& set = *draw.op->set;
    JitterState jitter = draw.op->state.state.jitter;
    jitter.x += shift.x;
    jitter.y += shift.y;
    t.s = draw.profile->subpixel_bits;
    t.smooth = draw.op->state.state.polygon_smooth;
    t.count = std::min(ordinals.size(), batch_capacity);
    t.filled = t.count <= batch_capacity / 2 ? batch_capacity / 2 : batch_capacity;
    for (std::size_t i = 0; i < t.filled; ++i) {
        t.ordinal[i] = ordinals[i < t.count ? i : 0];
        t.primitive[i] = &set.primitives[t.ordinal[i]];
    }
    const auto put = [&](std::size_t i, const auto& store) {
        for (std::size_t k = 0; k < 3; ++k) {
            const SnappedVertex& v = set.at[t.primitive[i]->vertex[k]];
            store(v.x + jitter.x, t.x[k]);
            store(v.y + jitter.y, t.y[k]);
            store(v.z, t.z[k]);
        }
    };
    // The first triangle fills all lanes: a tile inside a large triangle has few others.
    put(0, [&](auto value, auto* lanes) {
        const hn::CappedTag<decltype(value), batch_capacity / 2> d;
        for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d))
            hn::Store(hn::Set(d, value), d, lanes + i);
    });
    for (std::size_t i = 1; i < t.count; ++i)
        put(i, [i](auto value, auto* lanes) { lanes[i] = value; });
}

/// Whether each triangle has one depth.
HWY_INLINE bool all_level(const Corners& t) {
    const hn::CappedTag<std::uint32_t, batch_capacity / 2> d;
    auto any = hn::Zero(d);
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
        const auto z = hn::Load(d, t.z[0] + i);
        any = hn::Or(
            any, hn::Or(hn::Xor(z, hn::Load(d, t.z[1] + i)), hn::Xor(z, hn::Load(d, t.z[2] + i))));
    }
    return hn::AllTrue(d, hn::Eq(any, hn::Zero(d)));
}

#if HWY_HAVE_FLOAT64

using U32ForD64 = hn::Rebind<std::uint32_t, D64>;
using I64ForD64 = hn::Rebind<std::int64_t, D64>;
using U64ForD64 = hn::Rebind<std::uint64_t, D64>;

HWY_INLINE V64 load_integers(const std::int32_t* p) {
    return hn::PromoteTo(D64(), hn::Load(I32ForD64(), p));
}

/// Unsigned 32 bits: the conversion is signed, so the top bit is converted separately, as 2^31.
HWY_INLINE V64 load_unsigned(const std::uint32_t* p) {
    const auto flipped = hn::Xor(hn::Load(U32ForD64(), p), hn::Set(U32ForD64(), 0x80000000u));
    return hn::Add(hn::PromoteTo(D64(), hn::BitCast(I32ForD64(), flipped)), all(2147483648.0));
}

#endif  // HWY_HAVE_FLOAT64

/// Gathers the corners and the differences that planes need.
HWY_INLINE void gather_corners(const TileDraw& draw, std::span<const std::uint32_t> ordinals,
                               Corners& t, const JitterState& shift = {}) {
    gather_positions(draw, ordinals, t, shift);
    for (std::size_t i = 0; i < t.filled; ++i) {
        t.to_x[i] = draw.tile.x - (t.x[0][i] >> t.s);
        t.to_y[i] = draw.tile.y - (t.y[0][i] >> t.s);
    }
#if HWY_HAVE_FLOAT64
    const D64 d;
    const auto cell = all(double(1 << t.s)), inverse = all(1.0 / double(1 << t.s)),
               half = all(double(1 << t.s) / 2);
    const auto to_center = [&](V64 v) {
        return hn::Sub(hn::Add(hn::Mul(hn::Floor(hn::Mul(v, inverse)), cell), half), v);
    };
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
        const auto x0 = load_integers(t.x[0] + i), y0 = load_integers(t.y[0] + i);
        const auto dx1 = hn::Sub(load_integers(t.x[1] + i), x0),
                   dy1 = hn::Sub(load_integers(t.y[1] + i), y0);
        const auto dx2 = hn::Sub(load_integers(t.x[2] + i), x0),
                   dy2 = hn::Sub(load_integers(t.y[2] + i), y0);
        hn::Store(dx1, d, t.dx1 + i);
        hn::Store(dy1, d, t.dy1 + i);
        hn::Store(dx2, d, t.dx2 + i);
        hn::Store(dy2, d, t.dy2 + i);
        hn::Store(hn::Sub(hn::Mul(dx1, dy2), hn::Mul(dx2, dy1)), d, t.area2 + i);
        hn::Store(to_center(x0), d, t.ax + i);
        hn::Store(to_center(y0), d, t.ay + i);
    }
#endif
}

/// One plane for each triangle of a batch.
struct PlaneBatch {
    /// at the centre of corner 0's pixel, 16 fraction bits
    alignas(64) std::int64_t base[batch_capacity];
    alignas(64) std::int64_t c[batch_capacity];  ///< the same at the tile, modulo 2^64
    alignas(64) std::int64_t gx[batch_capacity], gy[batch_capacity];
    std::uint32_t sure = 0;  ///< lanes whose plane is set
    /// of the values at the corners, of smooth primitives
    alignas(64) std::int32_t low[batch_capacity], high[batch_capacity];

    HWY_INLINE PlaneLimits limits(std::size_t i) const { return {low[i], high[i]}; }
    HWY_INLINE TilePlane at(std::size_t i) const {
        return {static_cast<std::uint64_t>(c[i]), gx[i], gy[i]};
    }
};

#if HWY_HAVE_FLOAT64

/// Nearest integers to (first - second) 2^shift / area2, and the lanes in which this is proved.
struct GradientLanes {
    V64 value;
    hn::Mask<D64> sure;
};
HWY_INLINE GradientLanes gradient_lanes(V64 first, V64 second, V64 area2, int shift) {
    const auto below = [](V64 v, double limit) { return hn::Lt(hn::Abs(v), all(limit)); };
    const auto scaled = hn::Mul(hn::Sub(first, second), all(double(std::int64_t{1} << shift)));
    const auto q = hn::Div(scaled, area2);
    const auto g = nearest(q);
    // The exact remainder: g is split in two, because each product with a small area then fits 52
    // bits.
    const auto upper = hn::Mul(hn::Floor(hn::Mul(g, all(1.0 / 67108864))), all(67108864));
    const auto twice = hn::Mul(
        hn::Sub(hn::Sub(scaled, hn::Mul(upper, area2)), hn::Mul(hn::Sub(g, upper), area2)), all(2));
    const auto odd = hn::Ne(g, hn::Mul(hn::Floor(hn::Mul(g, all(0.5))), all(2)));
    const auto small = below(area2, 67108864);
    const auto minus = hn::Sub(hn::Zero(D64()), area2);
    const auto up = hn::Or(hn::Gt(twice, area2), hn::And(hn::Eq(twice, area2), odd));
    const auto down = hn::Or(hn::Lt(twice, minus), hn::And(hn::Eq(twice, minus), odd));
    const auto step = hn::Sub(hn::IfThenElseZero(up, all(1)), hn::IfThenElseZero(down, all(1)));
    // 2^51: q's rounding decides
    const auto decided = hn::Or(small, below(scaled, 2251799813685248.0));
    // 2^52
    const auto exact = hn::And(below(first, 4503599627370496.0), below(second, 4503599627370496.0));
    return {hn::Add(g, hn::IfThenElseZero(small, step)),
            hn::And(hn::And(exact, decided), below(q, 17592186044416.0))};  // 2^44
}

/// A vector of planes, as in a PlaneBatch.
struct PlaneLanes {
    hn::Vec<I64ForD64> gx, gy, base;
    std::uint32_t sure;
};

/// A vector of triangles with values at their corners: the products whose differences are
/// gradients times areas.
struct PlaneProducts {
    V64 first_x, second_x, first_y, second_y, area2, a0;

    template <class Value>
    HWY_INLINE PlaneProducts(const Corners& t, std::size_t i, const Value& value)
        : area2(hn::Load(D64(), t.area2 + i)), a0(value(0, i)) {
        const D64 d;
        const auto d1 = hn::Sub(value(1, i), a0), d2 = hn::Sub(value(2, i), a0);
        first_x = hn::Mul(d1, hn::Load(d, t.dy2 + i));
        second_x = hn::Mul(d2, hn::Load(d, t.dy1 + i));
        first_y = hn::Mul(d2, hn::Load(d, t.dx1 + i));
        second_y = hn::Mul(d1, hn::Load(d, t.dx2 + i));
    }
};

/// Gradients in integers modulo 2^64, as gradient() of gw/fast/raster/setup.h: also of large areas,
/// and of thin triangles up to 2^50.
struct WideGradients {
    hn::Vec<I64ForD64> value;
    hn::Mask<D64> sure;
};
HWY_INLINE WideGradients wide_gradients(V64 first, V64 second, V64 area2, int shift) {
    const I64ForD64 d;
    const auto below = [](V64 v, double limit) { return hn::Lt(hn::Abs(v), all(limit)); };
    const auto difference = hn::Sub(first, second);
    const auto q = hn::Div(hn::Mul(difference, all(double(std::int64_t{1} << shift))), area2);
    const auto g = integers(nearest(q)), area = hn::ConvertTo(d, area2);
    const auto rest =
        hn::Sub(hn::ShiftLeftSame(hn::ConvertTo(d, difference), shift), hn::Mul(g, area));
    const auto twice = hn::Add(rest, rest), minus = hn::Sub(hn::Zero(d), area);
    const auto odd = hn::Eq(hn::And(g, hn::Set(d, 1)), hn::Set(d, 1));
    const auto up = hn::Or(hn::Gt(twice, area), hn::And(hn::Eq(twice, area), odd));
    const auto down = hn::Or(hn::Lt(twice, minus), hn::And(hn::Eq(twice, minus), odd));
    const auto one = hn::Set(d, 1);
    // 2^52: the products are exact; 2^50: so is the quotient's integer, but for one
    const auto exact = hn::And(below(first, 4503599627370496.0), below(second, 4503599627370496.0));
    return {hn::Sub(hn::Add(g, hn::IfThenElseZero(up, one)), hn::IfThenElseZero(down, one)),
            hn::And(exact, below(q, 1125899906842624.0))};
}
HWY_NOINLINE inline PlaneLanes wide_planes(const Corners& t, std::size_t i,
                                           const PlaneProducts& p) {
    const D64 d;
    const I64ForD64 i64;
    const auto x = wide_gradients(p.first_x, p.second_x, p.area2, 16 + t.s),
               y = wide_gradients(p.first_y, p.second_y, p.area2, 16 + t.s);
    const auto step = hn::Add(hn::Mul(x.value, integers(hn::Load(d, t.ax + i))),
                              hn::Mul(y.value, integers(hn::Load(d, t.ay + i))));
    const auto base = hn::Add(hn::Add(hn::ShiftLeft<16>(integers(p.a0)), hn::Set(i64, 1 << 15)),
                              hn::ShiftRightSame(step, t.s));
    return {x.value, y.value, base, bits_of(d, hn::And(x.sure, y.sure), hn::Lanes(d))};
}

/// The same for the usual triangles.
HWY_INLINE PlaneLanes plane_lanes(const Corners& t, std::size_t i, const PlaneProducts& p) {
    const D64 d;
    const auto x = gradient_lanes(p.first_x, p.second_x, p.area2, 16 + t.s),
               y = gradient_lanes(p.first_y, p.second_y, p.area2, 16 + t.s);
    if (!hn::AllTrue(d, hn::And(x.sure, y.sure))) return wide_planes(t, i, p);
    const auto step =
        hn::Add(hn::Mul(x.value, hn::Load(d, t.ax + i)), hn::Mul(y.value, hn::Load(d, t.ay + i)));
    const auto base = hn::Add(hn::Add(hn::Mul(p.a0, all(65536)), all(32768)),
                              hn::Floor(hn::Mul(step, all(1.0 / double(1 << t.s)))));
    return {integers(x.value), integers(y.value), hn::ConvertTo(I64ForD64(), base),
            (1u << hn::Lanes(d)) - 1};
}

/// Keeps the limits of values of at most 31 bits.
template <class Value>
HWY_INLINE void set_limits(const Corners& t, const Value& value, PlaneBatch& out) {
    const I32ForD64 d;
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(D64())) {
        const auto a = value(0, i), b = value(1, i), c = value(2, i);
        hn::Store(hn::DemoteTo(d, hn::Min(a, hn::Min(b, c))), d, out.low + i);
        hn::Store(hn::DemoteTo(d, hn::Max(a, hn::Max(b, c))), d, out.high + i);
    }
}

/// Planes through integer values, a vector of triangles at a time: value(corner, first lane).
template <class Value>
HWY_INLINE void set_up_planes(const Corners& t, const Value& value, PlaneBatch& out) {
    const I64ForD64 d;
    out.sure = 0;
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
        const PlaneLanes p = plane_lanes(t, i, PlaneProducts(t, i, value));
        const auto steps = [&](const std::int32_t* to) {
            return hn::PromoteTo(d, hn::Load(I32ForD64(), to));
        };
        const auto to_tile =
            hn::Add(hn::Mul(p.gx, steps(t.to_x + i)), hn::Mul(p.gy, steps(t.to_y + i)));
        hn::Store(p.base, d, out.base + i);
        hn::Store(hn::Add(p.base, to_tile), d, out.c + i);
        hn::Store(p.gx, d, out.gx + i);
        hn::Store(p.gy, d, out.gy + i);
        out.sure |= p.sure << i;
    }
}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
