// Texture coordinate planes of up to 16 triangles at once. docs/manual.md, "Perspective"; scalar
// twin, also used for rare cases: gw/fast/raster/primitive.cpp. Does not evaluate them. Included
// once per Highway target.
#if defined(GW_FAST_COORDINATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COORDINATES_INL_H_
#undef GW_FAST_COORDINATES_INL_H_
#else
#define GW_FAST_COORDINATES_INL_H_
#endif

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

HWY_INLINE void planes_through(const Corners& t, const double (&value)[3][batch_capacity],
                               PlaneBatch& out) {
    set_up_planes(
        t, [&](std::size_t k, std::size_t i) { return hn::Load(D64(), value[k] + i); }, out);
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

HWY_NOINLINE inline void coordinate_planes(const TileDraw& draw, const Corners& t, int c, Wrap wrap,
                                           const RatioBatch& ratio, CoordinateBatch& out) {
    alignas(64) double s[3][batch_capacity], numerator[3][batch_capacity];
    gather(t, s, [&](std::uint32_t v) { return draw.op->texcoords->strq[v][c]; });
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
HWY_INLINE void put_texture_plane(const CoordinateBatch& c, std::size_t i, const PlaneBatch& q,
                                  bool slopes, TexturePlane& out) {
    put_plane(c.plane, i, out.plane);
    out.exponent = int(c.exponent[i]);
    out.k = std::int32_t(c.k[i]);
    out.slope = {};
    if (slopes) out.slope = coordinate_slope(slope_of(c.plane, i), slope_of(q, i));
}

/// Texture coordinates of a batch.
HWY_INLINE void set_up_perspective(const TileDraw& draw, const Corners& t, Denominators& shared,
                                   TexturePlanes* out) {
    const TextureState& state = draw.op->state.state.texture;
    const PlaneBatch& q = shared.q;
    CoordinateBatch u, v;
    shared.make(draw, t);
    coordinate_planes(draw, t, 0, state.wrap_s, shared.ratio, u);
    coordinate_planes(draw, t, 1, state.wrap_t, shared.ratio, v);
    const std::uint32_t sure = shared.sure() & u.plane.sure & v.plane.sure & u.finite & v.finite;
    const bool slopes = needs_rho(state);
    for (std::size_t i = 0; i < t.count; ++i) {
        if (!(sure >> i & 1)) {
            texture_one(draw, t, i, out[i]);
            continue;
        }
        put_plane(q, i, out[i].q);
        out[i].r = {};
        put_texture_plane(u, i, q, slopes, out[i].s);
        put_texture_plane(v, i, q, slopes, out[i].t);
        out[i].slope_x = draw.tile.x - t.to_x[i];
        out[i].slope_y = draw.tile.y - t.to_y[i];
    }
}

#else

struct Denominators {};

#endif  // HWY_HAVE_FLOAT64

/// Texture planes of a batch, out[0 .. count - 1].
inline void set_up_textures(const TileDraw& draw, const Corners& t,
                            [[maybe_unused]] Denominators& shared, TexturePlanes* out) {
#if HWY_HAVE_FLOAT64
    const TextureState& s = draw.op->state.state.texture;
    const bool mirrors = s.wrap_s == Wrap::MirroredRepeat || s.wrap_t == Wrap::MirroredRepeat;
    if (!draw.op->projective && !draw.op->wide_texcoords && !mirrors && !draw.op->units &&
        !is_sprite(draw.op->state.state, 0))
        return set_up_perspective(draw, t, shared, out);
#endif
    for (std::size_t i = 0; i < t.count; ++i) texture_one(draw, t, i, out[i]);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
