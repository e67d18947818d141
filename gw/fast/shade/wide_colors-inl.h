// Colours in perspective, and fog whose factor is of the fragment: planes of numerators and of a
// denominator of up to 16 triangles at once, and their values. docs/manual.md, "Perspective"; scalar
// twin, also used for rare cases: gw/fast/raster/primitive.cpp. Does not paint. Included once per
// Highway target.
#if defined(GW_FAST_WIDE_COLORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_WIDE_COLORS_INL_H_
#undef GW_FAST_WIDE_COLORS_INL_H_
#else
#define GW_FAST_WIDE_COLORS_INL_H_
#endif

#include "gw/fast/shade/colors-inl.h"
#include "gw/fast/shade/coordinates-inl.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/stages/fog.h"

#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

/// Numerators of one channel: numerators() of gw/stages/perspective.h for fractions 0 .. 1.
HWY_NOINLINE inline void channel_numerators(const Corners& t, const ColorWords& colors,
                                            std::size_t c, const RatioBatch& ratio, int bits,
                                            PlaneBatch& out) {
    const U64ForD64 u;
    const auto max = all(max_of_bits(bits)), unit = all(coordinate_unit);
    alignas(64) double value[3][batch_capacity];
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < t.filled; i += hn::Lanes(D64())) {
            const auto word = hn::ShiftRightSame(hn::Load(u, colors.at[k] + i), int(16 * c));
            const auto fraction = hn::Div(to_double(hn::And(word, hn::Set(u, 0xFFFFu))), max);
            hn::Store(nearest(hn::Mul(hn::Mul(unit, fraction), hn::Load(D64(), ratio.at[k] + i))),
                      D64(), value[k] + i);
        }
    planes_through(t, value, out);
}

#if HWY_TARGET == HWY_SCALAR

/// Each triangle's least and largest value of each channel.
HWY_INLINE void set_limits(const Corners& t, const ColorWords& colors, ColorPlanes* out) {
    for (std::size_t i = 0; i < t.count; ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const auto corner = [&](std::size_t k) {
                return std::uint16_t(colors.at[k][i] >> (16 * c));
            };
            out[i].low[c] = std::min({corner(0), corner(1), corner(2)});
            out[i].high[c] = std::max({corner(0), corner(1), corner(2)});
        }
}

#else

/// Each triangle's least and largest value of each channel.
HWY_INLINE void set_limits(const Corners& t, const ColorWords& colors, ColorPlanes* out) {
    const U64ForD64 words;
    const hn::Repartition<std::uint16_t, U64ForD64> d;
    alignas(64) std::uint64_t low[batch_capacity], high[batch_capacity];
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(words)) {
        const auto corner = [&](std::size_t k) {
            return hn::BitCast(d, hn::Load(words, colors.at[k] + i));
        };
        const auto a = corner(0), b = corner(1), c = corner(2);
        hn::Store(hn::BitCast(words, hn::Min(hn::Min(a, b), c)), words, low + i);
        hn::Store(hn::BitCast(words, hn::Max(hn::Max(a, b), c)), words, high + i);
    }
    for (std::size_t i = 0; i < t.count; ++i) {
        out[i].low = std::bit_cast<Rgba>(low[i]);
        out[i].high = std::bit_cast<Rgba>(high[i]);
    }
}

#endif  // HWY_TARGET == HWY_SCALAR

/// Colours in perspective; channels with one value on each triangle need no numerators. Returns the
/// lanes that are sure.
HWY_INLINE std::uint32_t perspective_channels(const TileDraw& draw, const Corners& t,
                                              const ColorWords& colors, const RatioBatch& ratio,
                                              ColorPlanes* out) {
    PlaneBatch plane;
    set_limits(t, colors, out);
    std::uint32_t sure = ~0u;
    const std::uint64_t differing = differing_bits(t, colors);
    for (std::size_t c = 0; c < 4; ++c) {
        if ((differing >> (16 * c) & 0xFFFF) == 0) continue;
        channel_numerators(t, colors, c, ratio, draw.op->state.bits, plane);
        for (std::size_t i = 0; i < t.count; ++i) {
            put_plane(plane, i, out[i].color[c]);
            if (t.smooth) out[i].limits[c] = plane.limits(i);
        }
        sure &= plane.sure;
    }
    return sure;
}

/// Fog coordinates of a batch; the lanes that are sure.
HWY_NOINLINE inline std::uint32_t fog_coordinates(const TileDraw& draw, const Corners& t,
                                                  const RatioBatch& ratio, ColorPlanes* out) {
    CoordinateBatch fog;
    alignas(64) double f[3][batch_capacity], numerator[3][batch_capacity];
    gather(t, f, [&](std::uint32_t v) { return std::abs(draw.op->fog->value[v]); });
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(D64())) {
        const Vertices3 at = load3(f, i);
        fog.finite |= finite_lanes(at) << i;
        numerators_above(hn::Zero(D64()), largest_fog_exponent, at, load3(ratio.at, i), i, fog,
                         numerator);
    }
    planes_through(t, numerator, fog.plane);
    const int log2_scale = fog_table_log2(draw.op->state.bits) + 8;
    for (std::size_t i = 0; i < t.count; ++i) {
        put_plane(fog.plane, i, out[i].fog);
        out[i].fog_scale = float(std::ldexp(1.0, int(fog.exponent[i]) + log2_scale));
    }
    return fog.plane.sure & fog.finite;
}

/// Fog factors of a batch; the lanes that are sure.
HWY_INLINE std::uint32_t wide_fog_factors(const TileDraw& draw, const Corners& t,
                                          ColorPlanes* out) {
    PlaneBatch plane;
    fog_planes(draw, t, plane);
    for (std::size_t i = 0; i < t.count; ++i) put_plane(plane, i, out[i].fog);
    return plane.sure;
}

/// Whether set_up_wide() makes all planes of a draw.
HWY_INLINE bool is_wide(const DrawOp& op) {
    return op.perspective_color || (is_flat(op) && op.fog_table);
}
/// Their planes; the lanes that are sure.
HWY_INLINE std::uint32_t put_denominators(const TileDraw& draw, const Corners& t,
                                          Denominators& shared, bool perspective,
                                          ColorPlanes* out) {
    shared.make(draw, t);
    for (std::size_t i = 0; i < t.count; ++i) {
        out[i].perspective = perspective;
        put_plane(shared.q, i, out[i].q);
        out[i].has_limits = t.smooth;
        if (t.smooth) out[i].q_limits = shared.q.limits(i);
    }
    return shared.sure();
}
HWY_NOINLINE inline std::uint32_t set_up_wide(const TileDraw& draw, const Corners& t,
                                              Denominators& shared, ColorPlanes* out) {
    const DrawOp& op = *draw.op;
    const RatioBatch& ratio = shared.ratio;
    std::uint32_t sure = put_denominators(draw, t, shared, op.perspective_color, out);
    if (op.perspective_color) {
        ColorWords colors;
        gather_colors(t, colors, [&](const SetupPrimitive& p) -> const std::vector<Rgba>& {
            return op.colors->of(p);
        });
        sure &= perspective_channels(draw, t, colors, ratio, out);
    } else
        for (std::size_t i = 0; i < t.count; ++i) {
            const Rgba color = one_color(draw, *t.primitive[i]);
            for (std::size_t c = 0; c < 4; ++c)
                out[i].color[c] = PrimitiveFrame::constant(color[c]);
        }
    if (!has_fog(op.state.state)) return sure;
    return sure &
           (op.fog_table ? fog_coordinates(draw, t, ratio, out) : wide_fog_factors(draw, t, out));
}

HWY_NOINLINE inline std::uint32_t set_up_wide_secondary(const TileDraw& draw, const Corners& t,
                                                        Denominators& shared, ColorPlanes* out) {
    ColorWords colors;
    gather_colors(t, colors, [&](const SetupPrimitive& p) -> const std::vector<Rgba>& {
        return draw.op->colors->secondary_of(p);
    });
    const std::uint32_t sure = put_denominators(draw, t, shared, true, out);
    return sure & perspective_channels(draw, t, colors, shared.ratio, out);
}

#endif  // HWY_HAVE_FLOAT64

/// Colour planes of a batch if narrow ones do not suffice, out[0 .. count - 1].
inline void set_up_colors(const TileDraw& draw, const Corners& t,
                          [[maybe_unused]] Denominators& shared, ColorPlanes* out) {
    std::uint32_t sure = 0;
#if HWY_HAVE_FLOAT64
    if (is_wide(*draw.op)) sure = set_up_wide(draw, t, shared, out);
#endif
    for (std::size_t i = 0; i < t.count; ++i)
        if (!(sure >> i & 1)) color_one(draw, t, i, out[i]);
}

/// The same of secondary colours.
inline void set_up_secondary(const TileDraw& draw, const Corners& t,
                             [[maybe_unused]] Denominators& shared, ColorPlanes* out) {
    std::uint32_t sure = 0;
#if HWY_HAVE_FLOAT64
    const bool smooth = draw.op->state.state.shade_model != ShadeModel::Flat;
    if (smooth && draw.profile->perspective_color)
        sure = set_up_wide_secondary(draw, t, shared, out);
#endif
    for (std::size_t i = 0; i < t.count; ++i)
        if (!(sure >> i & 1))
            make_secondary_planes(draw, *t.primitive[i], frame_of(draw, t.ordinal[i]), out[i]);
}

/// A triangle's colours in perspective at any block. Set up once for each triangle.
struct PerspectiveColors {
    WidePlaneLanes q, numerator[4];
    bool varies[4] = {}, affine = true;
    float w = 1;
    std::size_t aimed = batch_capacity;  ///< the triangle of the batch that it is set up for

    HWY_INLINE void aim(const ColorPlanes& p, std::size_t triangle) {
        if (aimed == triangle) return;
        aimed = triangle;
        affine = (p.q.gx | p.q.gy) == 0;
        if (affine)
            w = hn::GetLane(reciprocal_lanes(p.q, pixels_of(0, 0, 0)));
        else
            q.aim(p.q);
        for (std::size_t c = 0; c < 4; ++c) {
            varies[c] = p.low[c] != p.high[c];
            if (varies[c]) numerator[c].aim(p.color[c]);
        }
    }
    /// Calls put(channel, part, values) for a whole block.
    template <class Put>
    HWY_INLINE void at(const ColorPlanes& p, int bits, int bx, int by, const Put& put) const {
        const D32 d;
        const auto scale = hn::Set(F32(), float(max_of_bits(bits)));
        hn::Vec<F32> over[parts];
        reciprocals(bx, by, over);
        for (std::size_t c = 0; c < 4; ++c) {
            const auto low = hn::Set(d, std::uint32_t{p.low[c]}),
                       high = hn::Set(d, std::uint32_t{p.high[c]});
            const auto corner = numerator[c].corner(bx, by);
            for (std::size_t part = 0; part < parts; ++part) {
                if (!varies[c]) {
                    put(c, part, low);
                    continue;
                }
                const auto n = to_floats(numerator[c].above(corner, part));
                const auto v = to_nearest(hn::Mul(hn::Mul(n, over[part]), scale));
                put(c, part, hn::Min(hn::Max(v, low), high));
            }
        }
    }

private:
    HWY_INLINE void reciprocals(int bx, int by, hn::Vec<F32>* over) const {
        const F32 f;
        const auto corner = q.corner(bx, by);
        for (std::size_t part = 0; part < parts; ++part)
            over[part] = affine ? hn::Set(f, w)
                                : hn::Div(hn::Set(f, 1.0f), to_floats(q.above(corner, part)));
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
