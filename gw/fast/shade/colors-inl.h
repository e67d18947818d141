// Colour and fog planes of up to 16 triangles at once. docs/manual.md, "Planes"; scalar twin, also
// used for rare cases: gw/fast/raster/primitive.cpp. Does not evaluate them. Included once per
// Highway target.
#if defined(GW_FAST_COLORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COLORS_INL_H_
#undef GW_FAST_COLORS_INL_H_
#else
#define GW_FAST_COLORS_INL_H_
#endif

#include "gw/fast/raster/corners-inl.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/fast/vertices/vertex_values.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether colours (and fog) are planes of their own, without a denominator.
HWY_INLINE bool is_narrow(const DrawOp& op) { return !op.perspective_color && !op.fog_table; }

/// Whether a primitive has one colour.
HWY_INLINE bool is_flat(const DrawOp& op) {
    const State& s = op.state.state;
    return s.color_source == ColorSource::PolygonId || s.shade_model == ShadeModel::Flat ||
           op.uniform_color;
}
/// The one colour of a primitive: its provoking vertex's, or its identifier's.
HWY_INLINE Rgba one_color(const TileDraw& draw, const SetupPrimitive& p) {
    const VertexColors* const colors = draw.op->colors;
    return colors ? colors->of(p)[p.provoking] : id_color(draw, p);
}
HWY_INLINE bool has_fog(const State& s) {
    return s.fog.enable && s.color_source != ColorSource::PolygonId;
}

HWY_NOINLINE inline void color_one(const TileDraw& draw, const Corners& t, std::size_t i,
                                   ColorPlanes& out) {
    make_color_planes(draw, *t.primitive[i], frame_of(draw, t.ordinal[i]), out);
}

HWY_NOINLINE inline void narrow_one(const TileDraw& draw, const Corners& t, std::size_t i,
                                    NarrowBatch& out) {
    ColorPlanes wide;
    color_one(draw, t, i, wide);
    for (std::size_t k = 0; k < 5; ++k) {
        const TilePlane& p = k < 4 ? wide.color[k] : wide.fog;
        out.c[k][i] = std::uint32_t(p.c);
        out.gx[k][i] = std::uint32_t(p.gx);
        out.gy[k][i] = std::uint32_t(p.gy);
    }
}

#if HWY_HAVE_FLOAT64

/// The vertices' colours, four channels of 16 bits in a word.
struct ColorWords {
    alignas(64) std::uint64_t at[3][batch_capacity];
};
/// `colors` gives the colours that a primitive's vertices index.
template <class Colors>
HWY_INLINE void gather_colors(const Corners& t, ColorWords& out, const Colors& colors) {
    for (std::size_t i = 0; i < t.filled; ++i) {
        const Rgba* const from = colors(*t.primitive[i]).data();
        for (std::size_t k = 0; k < 3; ++k)
            std::memcpy(&out.at[k][i], from + t.primitive[i]->vertex[k], sizeof(Rgba));
    }
}

/// Integers below 2^52 as doubles.
HWY_INLINE V64 to_double(hn::Vec<U64ForD64> v) {
    const D64 d;
    // 2^52: or-ing v into its lowest bits adds v
    const auto magic = hn::Set(d, 4503599627370496.0);
    return hn::Sub(hn::BitCast(d, hn::Or(v, hn::BitCast(U64ForD64(), magic))), magic);
}

/// One channel of the vertex colours: planes for all lanes.
HWY_NOINLINE inline void channel_planes(const Corners& t, const ColorWords& colors, std::size_t c,
                                        PlaneBatch& out) {
    const U64ForD64 u;
    set_up_planes(
        t,
        [&](std::size_t k, std::size_t i) {
            const auto word = hn::ShiftRightSame(hn::Load(u, colors.at[k] + i), int(16 * c));
            return to_double(hn::And(word, hn::Set(u, 0xFFFFu)));
        },
        out);
}

HWY_INLINE void fog_planes(const TileDraw& draw, const Corners& t, PlaneBatch& out) {
    alignas(64) double factor[3][batch_capacity];
    gather(t, factor, [&](std::uint32_t v) { return draw.op->fog->value[v]; });
    set_up_planes(
        t, [&](std::size_t k, std::size_t i) { return nearest(hn::Load(D64(), factor[k] + i)); },
        out);
}

/// Bits in which any triangle's corners differ. A channel without such bits is constant on each
/// triangle. Alpha, ambient light and black usually are.
HWY_INLINE std::uint64_t differing_bits(const Corners& t, const ColorWords& colors) {
    const U64ForD64 u;
    auto any = hn::Zero(u);
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(u)) {
        const auto first = hn::Load(u, colors.at[0] + i);
        any = hn::Or(any, hn::Or(hn::Xor(first, hn::Load(u, colors.at[1] + i)),
                                 hn::Xor(first, hn::Load(u, colors.at[2] + i))));
    }
    alignas(64) std::uint64_t lanes[8];
    hn::Store(any, u, lanes);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < hn::Lanes(u); ++i) bits |= lanes[i];
    return bits;
}
/// Triangles whose R, G and B are 0.
HWY_INLINE std::uint32_t black_lanes(const Corners& t, const ColorWords& colors) {
    const U64ForD64 u;
    const auto rgb = hn::Set(u, 0xFFFFFFFFFFFFu);
    std::uint32_t black = 0;
    for (std::size_t i = 0; i < t.filled; i += hn::Lanes(u)) {
        const auto corner = [&](std::size_t k) { return hn::Load(u, colors.at[k] + i); };
        const auto any = hn::And(hn::Or(hn::Or(corner(0), corner(1)), corner(2)), rgb);
        black |= bits_of(u, hn::Eq(any, hn::Zero(u)), hn::Lanes(u)) << i;
    }
    return black;
}
HWY_INLINE void put_constant(const Corners& t, const ColorWords& colors, std::size_t k,
                             NarrowBatch& out) {
    for (std::size_t i = 0; i < t.filled; ++i) {
        out.c[k][i] = std::uint32_t(colors.at[0][i] >> (16 * k) & 0xFFFF) * 65536u + 32768u;
        out.gx[k][i] = out.gy[k][i] = 0;
    }
}

/// Stores a batch's plane of one channel, modulo 2^32.
HWY_INLINE void put_channel(const Corners& t, const PlaneBatch& plane, std::size_t k,
                            NarrowBatch& out) {
    const auto low = [&](const std::int64_t* from, std::uint32_t* to) {
        for (std::size_t i = 0; i < t.filled; i += hn::Lanes(D64()))
            hn::Store(hn::TruncateTo(U32ForD64(),
                                     hn::BitCast(U64ForD64(), hn::Load(I64ForD64(), from + i))),
                      U32ForD64(), to + i);
    };
    low(plane.c, out.c[k]);
    low(plane.gx, out.gx[k]);
    low(plane.gy, out.gy[k]);
}

/// Smooth colours of a batch; the lanes that are sure.
HWY_INLINE std::uint32_t smooth_colors(const TileDraw& draw, const Corners& t, NarrowBatch& out) {
    ColorWords colors;
    PlaneBatch plane;
    gather_colors(t, colors, [&](const SetupPrimitive& p) -> const std::vector<Rgba>& {
        return draw.op->colors->of(p);
    });
    out.black = black_lanes(t, colors);
    std::uint32_t sure = ~0u;
    const std::uint64_t differing = differing_bits(t, colors);
    for (std::size_t k = 0; k < 4; ++k) {
        if ((differing >> (16 * k) & 0xFFFF) == 0) {
            put_constant(t, colors, k, out);
            continue;
        }
        channel_planes(t, colors, k, plane);
        put_channel(t, plane, k, out);
        sure &= plane.sure;
    }
    return sure;
}

HWY_INLINE std::uint32_t fog_factors(const TileDraw& draw, const Corners& t, NarrowBatch& out) {
    PlaneBatch plane;
    fog_planes(draw, t, plane);
    put_channel(t, plane, 4, out);
    return plane.sure;
}

#endif  // HWY_HAVE_FLOAT64

/// Flat colours of a batch, without its fog.
HWY_INLINE void flat_colors(const TileDraw& draw, const Corners& t, NarrowBatch& out) {
    for (std::size_t i = 0; i < t.count; ++i) {
        const Rgba color = one_color(draw, *t.primitive[i]);
        for (std::size_t k = 0; k < 4; ++k) {
            out.c[k][i] = (std::uint32_t{color[k]} << 16) + (1u << 15);
            out.gx[k][i] = out.gy[k][i] = 0;
        }
        out.black |= (color[0] | color[1] | color[2]) == 0 ? 1u << i : 0;
    }
}

/// Narrow planes of a batch.
inline void set_up_narrow(const TileDraw& draw, const Corners& t, NarrowBatch& out) {
    const State& s = draw.op->state.state;
    std::uint32_t sure = ~0u;
    out.black = 0;
    if (is_flat(*draw.op)) flat_colors(draw, t, out);
    if (is_flat(*draw.op) && !has_fog(s)) return;
#if HWY_HAVE_FLOAT64
    if (!is_flat(*draw.op)) sure = smooth_colors(draw, t, out);
    if (has_fog(s)) sure &= fog_factors(draw, t, out);
#else
    sure = 0;
#endif
    for (std::size_t i = 0; i < t.count; ++i)
        if (!(sure >> i & 1)) narrow_one(draw, t, i, out);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
