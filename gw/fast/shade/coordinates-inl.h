// Texture coordinate planes of up to 16 triangles at once. docs/manual.md, "Perspective"; scalar
// twin, also used for rare cases: gw/fast/raster/primitive.cpp. Does not evaluate them. Included
// once per Highway target.
#if defined(GW_FAST_COORDINATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COORDINATES_INL_H_
#undef GW_FAST_COORDINATES_INL_H_
#else
#define GW_FAST_COORDINATES_INL_H_
#endif

#include "gw/fast/plan/texels.h"
#include "gw/fast/raster/corners-inl.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/stages/raster/points.h"
#include "gw/stages/texels.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_NOINLINE inline void texture_one(const TileDraw& draw, const Corners& t, std::size_t i,
                                     TexturePlanes& out) {
    make_texture_planes(draw, *t.primitive[i], frame_of(draw, t.ordinal[i]), out);
}

#if HWY_HAVE_FLOAT64

/// One texture coordinate of a batch: numerators() of gw/stages/perspective.h in vectors.
struct CoordinateBatch {
    PlaneBatch plane;
    alignas(64) double exponent[batch_capacity], k[batch_capacity];
    std::uint32_t finite = 0;
};

struct Vertices3 {
    V64 at[3];
};
HWY_INLINE Vertices3 load3(const double (&p)[3][batch_capacity], std::size_t i) {
    const D64 d;
    return {{hn::Load(d, p[0] + i), hn::Load(d, p[1] + i), hn::Load(d, p[2] + i)}};
}
HWY_INLINE V64 least(const Vertices3& v) { return hn::Min(hn::Min(v.at[0], v.at[1]), v.at[2]); }
HWY_INLINE V64 most(const Vertices3& v) { return hn::Max(hn::Max(v.at[0], v.at[1]), v.at[2]); }

inline constexpr double coordinate_unit = 1073741824.0;  // 2^30

/// wmin / w_i at each corner of a batch.
struct RatioBatch {
    alignas(64) double at[3][batch_capacity];
    std::uint32_t finite = 0;
};

/// Numerators of lanes i .. above the integers k, with exponents 0 .. largest: stores values in
/// `out`, exponents in the batch.
HWY_INLINE void numerators_above(V64 k, int largest, const Vertices3& s, const Vertices3& ratio,
                                 std::size_t i, CoordinateBatch& batch,
                                 double (&out)[3][batch_capacity]) {
    const D64 d;
    const auto zero = hn::Zero(d), one = all(1), unit = all(coordinate_unit);
    const auto range = hn::Sub(most(s), k);
    auto power = one, inverse = one, exponent = zero;
    for (int e = 0; e < largest; ++e) {
        const auto grows = hn::Lt(power, range);
        if (hn::AllFalse(d, grows)) break;
        power = hn::IfThenElse(grows, hn::Add(power, power), power);
        inverse = hn::IfThenElse(grows, hn::Mul(inverse, all(0.5)), inverse);
        exponent = hn::Add(exponent, hn::IfThenElseZero(grows, one));
    }
    for (std::size_t v = 0; v < 3; ++v) {
        const auto fraction = hn::Max(zero, hn::Min(hn::Mul(hn::Sub(s.at[v], k), inverse), one));
        const auto u = nearest(hn::Mul(hn::Mul(unit, fraction), ratio.at[v]));
        hn::Store(hn::Max(zero, hn::Min(u, unit)), d, out[v] + i);
    }
    hn::Store(exponent, d, batch.exponent + i);
}

/// The same above the integer part that a texture coordinate has under `wrap`; stores it too.
HWY_INLINE void numerator_lanes(const Vertices3& s, const Vertices3& ratio, Wrap wrap,
                                std::size_t i, CoordinateBatch& batch,
                                double (&out)[3][batch_capacity]) {
    const D64 d;
    auto k = hn::Floor(least(s));
    if (wrap != Wrap::Repeat) k = hn::Max(all(-1024), hn::Min(k, all(1023)));
    numerators_above(k, 10, s, ratio, i, batch, out);
    hn::Store(wrap != Wrap::Repeat ? k : hn::Zero(d), d, batch.k + i);
}

HWY_INLINE std::uint32_t finite_lanes(const Vertices3& v) {
    const D64 d;
    const auto zero = hn::Zero(d);
    auto finite = hn::Eq(hn::Sub(v.at[0], v.at[0]), zero);
    for (std::size_t k = 1; k < 3; ++k)
        finite = hn::And(finite, hn::Eq(hn::Sub(v.at[k], v.at[k]), zero));
    return bits_of(d, finite, hn::Lanes(d));
}

/// Planes, and their limits if they need them.
HWY_INLINE void planes_through(const Corners& t, const double (&value)[3][batch_capacity],
                               PlaneBatch& out) {
    const auto at = [&](std::size_t k, std::size_t i) { return hn::Load(D64(), value[k] + i); };
    set_up_planes(t, at, out);
    if (t.smooth) set_limits(t, at, out);
}

HWY_NOINLINE inline void make_ratios(const TileDraw& draw, const Corners& t, RatioBatch& out) {
    const D64 d;
    alignas(64) double w[3][batch_capacity];
    gather(t, w, [&](std::uint32_t vertex) { return draw.op->set->w[vertex]; });
    out.finite = 0;
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
        const Vertices3 at = load3(w, i);
        const auto low = least(at);
        const Vertices3 ratio{
            {hn::Div(low, at.at[0]), hn::Div(low, at.at[1]), hn::Div(low, at.at[2])}};
        for (std::size_t k = 0; k < 3; ++k) hn::Store(ratio.at[k], d, out.at[k] + i);
        out.finite |= finite_lanes(ratio) << i;
    }
}

HWY_NOINLINE inline void coordinate_planes(const VertexTexcoords& texcoords, const Corners& t,
                                           int c, Wrap wrap, const RatioBatch& ratio,
                                           CoordinateBatch& out) {
    alignas(64) double s[3][batch_capacity], numerator[3][batch_capacity];
    gather(t, s, [&](std::uint32_t v) { return texcoords.strq[v][c]; });
    out.finite = 0;
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(D64())) {
        const Vertices3 at = load3(s, i);
        out.finite |= finite_lanes(at) << i;
        numerator_lanes(at, load3(ratio.at, i), wrap, i, out, numerator);
    }
    planes_through(t, numerator, out.plane);
}

HWY_NOINLINE inline void denominator_planes(const Corners& t, const RatioBatch& ratio,
                                            PlaneBatch& out) {
    const D64 d;
    alignas(64) double q[3][batch_capacity];
    const auto unit = all(coordinate_unit);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
            const auto v = nearest(hn::Mul(unit, hn::Load(d, ratio.at[k] + i)));
            hn::Store(hn::Max(all(1), hn::Min(v, unit)), d, q[k] + i);
        }
    planes_through(t, q, out);
}

/// What the colours and the texture coordinates of a batch share. Made when one of them is.
struct Denominators {
    RatioBatch ratio;
    PlaneBatch q;

    HWY_INLINE void make(const TileDraw& draw, const Corners& t) {
        if (made_) return;
        made_ = true;
        make_ratios(draw, t, ratio);
        denominator_planes(t, ratio, q);
    }
    /// The lanes that are sure.
    HWY_INLINE std::uint32_t sure() const { return q.sure & ratio.finite; }

private:
    bool made_ = false;
};

HWY_INLINE PlaneSlope slope_of(const PlaneBatch& p, std::size_t i) {
    return {double(p.gx[i]), double(p.gy[i]), double(p.base[i] >> 16)};
}

/// Copies member by member: a copy of a whole plane would wait for its parts to be stored.
HWY_INLINE void put_plane(const PlaneBatch& from, std::size_t i, TilePlane& out) {
    out.c = static_cast<std::uint64_t>(from.c[i]);
    out.gx = from.gx[i];
    out.gy = from.gy[i];
    out.sliver = false;
}
/// One unit of a draw.
struct UnitBatch {
    const TextureState& state;
    const UnitOp& unit;
    std::size_t number;
    bool has_slopes = needs_rho(state), has_plane_slopes = has_slopes && unit.texels->texels.with_r,
         has_r = state.shadow_compare || unit.texels->texels.with_r;

    HWY_INLINE void put(const Corners& t, const CoordinateBatch& c, std::size_t i,
                        const PlaneBatch& q, TexturePlane& out) const {
        put_plane(c.plane, i, out.plane);
        out.exponent = int(c.exponent[i]);
        out.k = std::int32_t(c.k[i]);
        if (t.smooth) out.limits = c.plane.limits(i);
        out.slope = {};
        if (has_slopes) out.slope = coordinate_slope(slope_of(c.plane, i), slope_of(q, i));
        if (has_plane_slopes) out.plane_slope = slope_of(c.plane, i);
    }
    /// The planes of triangle i but for s, t and r.
    HWY_INLINE void put(const TileDraw& draw, const Corners& t, std::size_t i, const PlaneBatch& q,
                        TexturePlanes& out) const {
        put_plane(q, i, out.q);
        out.has_limits = t.smooth;
        if (t.smooth) out.q_limits = q.limits(i);
        if (has_plane_slopes) out.q_slope = slope_of(q, i);
        out.slope_x = draw.tile.x - t.to_x[i];
        out.slope_y = draw.tile.y - t.to_y[i];
    }
    /// Where the planes of triangle i belong.
    HWY_INLINE TexturePlanes& of(TexturePlanes* out, std::size_t i) const {
        return number == 0 ? out[i] : out[i].more[number - 1];
    }
};

/// Texture coordinates of a batch that are not divided by q. Returns the lanes that are sure.
HWY_NOINLINE inline std::uint32_t set_up_perspective(const TileDraw& draw, const Corners& t,
                                                     const UnitBatch& unit, Denominators& shared,
                                                     TexturePlanes* out) {
    const PlaneBatch& q = shared.q;
    const VertexTexcoords& texcoords = *unit.unit.texcoords;
    CoordinateBatch u, v;
    shared.make(draw, t);
    coordinate_planes(texcoords, t, 0, unit.state.wrap_s, shared.ratio, u);
    coordinate_planes(texcoords, t, 1, unit.state.wrap_t, shared.ratio, v);
    for (std::size_t i = 0; i < t.count; ++i) {
        TexturePlanes& planes = unit.of(out, i);
        unit.put(draw, t, i, q, planes);
        unit.put(t, u, i, q, planes.s);
        unit.put(t, v, i, q, planes.t);
        if (unit.has_r) planes.r = {};
    }
    return shared.sure() & u.plane.sure & v.plane.sure & u.finite & v.finite;
}

/// Values at the corners over w, over the greatest |q / w|: projective() of
/// gw/stages/perspective.h.
struct OverW {
    alignas(64) double w[3][batch_capacity], greatest[batch_capacity];
    std::uint32_t finite = 0;  ///< where the greatest is above 0

    HWY_INLINE Vertices3 at(const double (&value)[3][batch_capacity], std::size_t i) const {
        const auto h = hn::Load(D64(), greatest + i);
        Vertices3 out = over_w(value, i);
        for (V64& v : out.at) v = hn::Div(v, h);
        return out;
    }
    HWY_INLINE Vertices3 over_w(const double (&value)[3][batch_capacity], std::size_t i) const {
        const Vertices3 a = load3(value, i), b = load3(w, i);
        return {{hn::Div(a.at[0], b.at[0]), hn::Div(a.at[1], b.at[1]), hn::Div(a.at[2], b.at[2])}};
    }
};
HWY_INLINE V64 greatest_of(const Vertices3& v) {
    return hn::Max(hn::Max(hn::Abs(v.at[0]), hn::Abs(v.at[1])), hn::Abs(v.at[2]));
}
/// 2^30 v to nearest, -2^30 .. 2^30.
HWY_INLINE V64 in_units(V64 v) {
    const auto unit = all(coordinate_unit);
    return hn::Max(hn::Neg(unit), hn::Min(nearest(hn::Mul(unit, v)), unit));
}

/// exponent_above() of gw/base/powers.h, from -60 to 60.
HWY_INLINE hn::Vec<I64ForD64> exponents_above(V64 v) {
    const I64ForD64 d;
    const auto bits = hn::BitCast(d, v);
    const auto floor = hn::Sub(hn::ShiftRight<52>(bits), hn::Set(d, 1023)),
               mantissa = hn::And(bits, hn::Set(d, (std::int64_t{1} << 52) - 1));
    const auto e = hn::Add(floor, hn::IfThenZeroElse(hn::Eq(mantissa, hn::Zero(d)), hn::Set(d, 1)));
    return hn::Max(hn::Set(d, -60), hn::Min(e, hn::Set(d, 60)));
}

/// The denominators; sets the greatest |q / w|.
HWY_NOINLINE inline void projective_denominators(const VertexTexcoords& texcoords, const Corners& t,
                                                 OverW& over, PlaneBatch& out) {
    const D64 d;
    alignas(64) double q[3][batch_capacity], at[3][batch_capacity];
    gather(t, q, [&](std::uint32_t v) { return texcoords.strq[v].w; });
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
        const Vertices3 over_w = over.over_w(q, i);
        const auto h = greatest_of(over_w);
        hn::Store(h, d, over.greatest + i);
        over.finite |= (finite_lanes(over_w) & bits_of(d, hn::Gt(h, hn::Zero(d)), hn::Lanes(d)))
                       << i;
        const Vertices3 scaled = over.at(q, i);
        for (std::size_t k = 0; k < 3; ++k) hn::Store(in_units(scaled.at[k]), d, at[k] + i);
    }
    planes_through(t, at, out);
}

HWY_NOINLINE inline void projective_planes(const VertexTexcoords& texcoords, const Corners& t,
                                           int c, const OverW& over, CoordinateBatch& out) {
    const D64 d;
    const I64ForD64 i64;
    alignas(64) double s[3][batch_capacity], numerator[3][batch_capacity];
    gather(t, s, [&](std::uint32_t v) { return texcoords.strq[v][c]; });
    out.finite = 0;
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(d)) {
        const Vertices3 v = over.at(s, i);
        const auto e = exponents_above(greatest_of(v));
        const auto scale =
            hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(i64, 1023), e)));  // 2^-e
        out.finite |= finite_lanes(v) << i;
        for (std::size_t k = 0; k < 3; ++k)
            hn::Store(in_units(hn::Mul(v.at[k], scale)), d, numerator[k] + i);
        hn::Store(doubles(e), d, out.exponent + i);
        hn::Store(hn::Zero(d), d, out.k + i);
    }
    planes_through(t, numerator, out.plane);
}

/// The same of coordinates that are divided by q.
HWY_NOINLINE inline std::uint32_t set_up_projective(const TileDraw& draw, const Corners& t,
                                                    const UnitBatch& unit, TexturePlanes* out) {
    const VertexTexcoords& texcoords = *unit.unit.texcoords;
    OverW over;
    PlaneBatch q;
    CoordinateBatch c[3];
    gather(t, over.w, [&](std::uint32_t vertex) { return draw.op->set->w[vertex]; });
    projective_denominators(texcoords, t, over, q);
    std::uint32_t sure = over.finite & q.sure;
    for (int k = 0; k < 3; ++k) {
        projective_planes(texcoords, t, k, over, c[k]);
        sure &= c[k].finite & c[k].plane.sure;
    }
    for (std::size_t i = 0; i < t.count; ++i) {
        TexturePlanes& planes = unit.of(out, i);
        unit.put(draw, t, i, q, planes);
        unit.put(t, c[0], i, q, planes.s);
        unit.put(t, c[1], i, q, planes.t);
        unit.put(t, c[2], i, q, planes.r);
    }
    return sure;
}

/// Whether a unit's planes are set up in vectors.
HWY_INLINE bool has_batches(const TileDraw& draw, const UnitBatch& of) {
    const auto mirrors = [](Wrap wrap) { return wrap == Wrap::MirroredRepeat; };
    return !is_sprite(draw.op->state.state, of.number) &&
           (of.unit.projective ||
            !(of.unit.texcoords->are_wide || mirrors(of.state.wrap_s) || mirrors(of.state.wrap_t)));
}
/// The lanes that are sure.
HWY_INLINE std::uint32_t set_up_unit(const TileDraw& draw, const Corners& t, const UnitBatch& of,
                                     Denominators& shared, TexturePlanes* out) {
    if (!has_batches(draw, of)) return 0;
    return of.unit.projective ? set_up_projective(draw, t, of, out)
                              : set_up_perspective(draw, t, of, shared, out);
}
/// The same of all units.
HWY_NOINLINE inline std::uint32_t set_up_units(const TileDraw& draw, const Corners& t,
                                               Denominators& shared, TexturePlanes* out) {
    const DrawOp& op = *draw.op;
    const auto state = [&](std::size_t unit) -> const TextureState& {
        return texture_of(op.state.state, unit);
    };
    if (!op.units)
        return set_up_unit(draw, t, {state(0), {op.texels, op.texcoords, op.projective}, 0}, shared,
                           out);
    for (std::size_t i = 0; i < t.count; ++i) out[i].more.resize(max_texture_units - 1);
    std::uint32_t sure = ~0u;
    for (std::size_t unit = 0; unit < max_texture_units && sure != 0; ++unit)
        if ((*op.units)[unit].texels)
            sure &= set_up_unit(draw, t, {state(unit), (*op.units)[unit], unit}, shared, out);
    return sure;
}

#else

struct Denominators {};

#endif  // HWY_HAVE_FLOAT64

/// Texture planes of a batch, out[0 .. count - 1].
inline void set_up_textures(const TileDraw& draw, const Corners& t,
                            [[maybe_unused]] Denominators& shared, TexturePlanes* out) {
    std::uint32_t sure = 0;
#if HWY_HAVE_FLOAT64
    sure = set_up_units(draw, t, shared, out);
#endif
    for (std::size_t i = 0; i < t.count; ++i)
        if (!(sure >> i & 1)) texture_one(draw, t, i, out[i]);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
