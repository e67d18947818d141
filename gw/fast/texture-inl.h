// Textures on a block of 16 pixels: coordinates, level of detail, filters. docs/manual.md, "Textures";
// scalar twins: gw/texels.cpp, gw/reference/texture_unit.cpp. Does not combine with the fragment's colour.
// Included once per Highway target.
#if defined(GW_FAST_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TEXTURE_INL_H_
#undef GW_FAST_TEXTURE_INL_H_
#else
#define GW_FAST_TEXTURE_INL_H_
#endif

#include "gw/fast/planes-inl.h"
#include "gw/fast/primitive.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// 2^e, a normal number.
inline double power_of_two(int e) { return std::bit_cast<double>(std::uint64_t(e + 1023) << 52); }

using VI = hn::Vec<I32>;
using VF = hn::Vec<F32>;

/// Four channels of one texel per lane.
struct TexelLanes {
    V32 channel[4];
};

HWY_INLINE TexelLanes fetch(const FastTexels& t, VI index) {
    const D32 d;
    TexelLanes out;
    if (!t.packed.empty()) {
        const auto v = hn::GatherIndex(d, t.packed.data(), index);
        const auto byte = hn::Set(d, 255u);
        out.channel[0] = hn::And(v, byte);
        out.channel[1] = hn::And(hn::ShiftRight<8>(v), byte);
        out.channel[2] = hn::And(hn::ShiftRight<16>(v), byte);
        out.channel[3] = hn::ShiftRight<24>(v);
        return out;
    }
    const auto* base = reinterpret_cast<const std::uint32_t*>(t.wide.data());
    const auto two = hn::Add(index, index);
    const auto rg = hn::GatherIndex(d, base, two),
               ba = hn::GatherIndex(d, base, hn::Add(two, hn::Set(I32(), 1)));
    const auto low = hn::Set(d, 0xFFFFu);
    out.channel[0] = hn::And(rg, low);
    out.channel[1] = hn::ShiftRight<16>(rg);
    out.channel[2] = hn::And(ba, low);
    out.channel[3] = hn::ShiftRight<16>(ba);
    return out;
}

/// bilinear() of gw/texels.h, more than 8 bits.
HWY_INLINE V32 bilinear_wide(V32 a, V32 b, V32 c, V32 e, V32 wx, V32 wy) {
    const D32 d;
    const auto whole = hn::Set(d, 256u);
    const auto mix = [&](V32 p, V32 q, V32 w) {
        return hn::Add(hn::Mul(p, hn::Sub(whole, w)), hn::Mul(q, w));
    };
    return hn::ShiftRight<16>(hn::Add(mix(mix(a, b, wx), mix(c, e, wx), wy), hn::Set(d, 1u << 15)));
}

/// Four packed texels of each lane: a b above c e.
struct PackedCorners {
    V32 a, b, c, e;
};

#if HWY_TARGET == HWY_SCALAR

/// bilinear() of gw/texels.h, 8 bits, one channel.
HWY_INLINE V32 bilinear_byte(V32 a, V32 b, V32 c, V32 e, V32 wx, V32 wy) {
    const I32 i;
    const auto s = [&](V32 v) { return hn::BitCast(i, v); };
    const auto half = hn::Set(i, 128), x = hn::ShiftLeft<6>(s(wx));
    const auto row = [&](V32 p, V32 q) {
        return hn::Add(hn::ShiftLeft<6>(s(p)),
                       hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(s(q), s(p)), x), half)));
    };
    const auto t0 = row(a, b), t1 = row(c, e);
    const auto t = hn::Add(t0, hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(t1, t0), s(wy)), half)));
    return hn::BitCast(D32(), hn::ShiftRight<6>(hn::Add(t, hn::Set(i, 32))));
}

HWY_INLINE TexelLanes bilinear_bytes(const PackedCorners& t, V32 wx, V32 wy) {
    const auto byte = hn::Set(D32(), 255u);
    TexelLanes out;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto of = [&](V32 v) { return hn::And(hn::ShiftRightSame(v, int(8 * k)), byte); };
        out.channel[k] = bilinear_byte(of(t.a), of(t.b), of(t.c), of(t.e), wx, wy);
    }
    return out;
}

#else

/// bilinear() of gw/texels.h, 8 bits: two channels in the halves of each lane, every product a rounding
/// 15-bit one.
HWY_INLINE V32 bilinear_halves(V32 a, V32 b, V32 c, V32 e, V32 wx, V32 wy) {
    const hn::Repartition<std::int16_t, D32> h;
    const auto s = [&](V32 v) { return hn::BitCast(h, v); };
    const auto x = hn::ShiftLeft<6>(s(wx)), y = hn::ShiftLeft<6>(s(wy));
    const auto row = [&](V32 p, V32 q) {
        return hn::Add(hn::ShiftLeft<6>(s(p)), hn::MulFixedPoint15(hn::ShiftLeft<7>(hn::Sub(s(q), s(p))), x));
    };
    const auto t0 = row(a, b), t1 = row(c, e);
    const auto t = hn::Add(t0, hn::MulFixedPoint15(hn::ShiftLeft<1>(hn::Sub(t1, t0)), y));
    return hn::BitCast(D32(), hn::ShiftRight<6>(hn::Add(t, hn::Set(h, std::int16_t{32}))));
}

HWY_INLINE TexelLanes bilinear_bytes(const PackedCorners& t, V32 wx, V32 wy) {
    const D32 d;
    const auto bytes = hn::Set(d, 0x00FF00FFu), low = hn::Set(d, 0xFFFFu);
    const auto even = [&](V32 v) { return hn::And(v, bytes); };
    const auto odd = [&](V32 v) { return hn::And(hn::ShiftRight<8>(v), bytes); };
    const auto both = [&](V32 w) { return hn::Or(w, hn::ShiftLeft<16>(w)); };
    const auto x = both(wx), y = both(wy);
    const auto rb = bilinear_halves(even(t.a), even(t.b), even(t.c), even(t.e), x, y),
               ga = bilinear_halves(odd(t.a), odd(t.b), odd(t.c), odd(t.e), x, y);
    return {{hn::And(rb, low), hn::And(ga, low), hn::ShiftRight<16>(rb), hn::ShiftRight<16>(ga)}};
}

#endif  // HWY_TARGET == HWY_SCALAR

/// Where the lanes' four texels stand: columns, and where their rows start.
struct TexelCells {
    VI left, right, upper, lower;
};

/// One gather each, for lanes of any cells.
HWY_INLINE PackedCorners gather_corners(const std::uint32_t* texels, const TexelCells& at) {
    const auto fetch = [&](VI row, VI column) {
        return hn::GatherIndex(D32(), texels, hn::Add(row, column));
    };
    return {fetch(at.upper, at.left), fetch(at.upper, at.right), fetch(at.lower, at.left),
            fetch(at.lower, at.right)};
}

#if HWY_MAX_BYTES >= 32

/// Lanes that look at one pair of rows take their texels from a window of each, loaded once: pixels side by
/// side look at texels side by side.
struct TexelWindows {
    const std::uint32_t* texels;
    const TexelCells& at;
    alignas(64) std::int32_t column[lanes32], upper[lanes32], lower[lanes32];
    PackedCorners found;

    HWY_INLINE TexelWindows(const std::uint32_t* t, const TexelCells& cells) : texels(t), at(cells) {
        const I32 i;
        hn::Store(at.left, i, column), hn::Store(at.upper, i, upper), hn::Store(at.lower, i, lower);
        found.a = found.b = found.c = found.e = hn::Zero(D32());
    }
    /// Fills the lanes that look at the rows of lane `first`, near it; which they are.
    HWY_INLINE std::uint32_t fill(std::size_t first) {
        const D32 d;
        const I32 i;
        const std::int32_t origin = std::max(column[first] - int(lanes32 / 2 - 1), 0);
        const auto x0 = hn::BitCast(d, hn::Sub(at.left, hn::Set(i, origin))),
                   x1 = hn::BitCast(d, hn::Sub(at.right, hn::Set(i, origin)));
        const auto rows =
            hn::And(hn::Eq(at.upper, hn::Set(i, upper[first])), hn::Eq(at.lower, hn::Set(i, lower[first])));
        const auto own =
            hn::And(hn::RebindMask(d, rows), hn::Lt(hn::Or(x0, x1), hn::Set(d, std::uint32_t(lanes32))));
        const auto inside = hn::Set(d, std::uint32_t(lanes32 - 1));
        const auto left = hn::IndicesFromVec(d, hn::And(x0, inside)),
                   right = hn::IndicesFromVec(d, hn::And(x1, inside));
        const auto above = hn::LoadU(d, texels + upper[first] + origin),
                   below = hn::LoadU(d, texels + lower[first] + origin);
        found.a = hn::IfThenElse(own, hn::TableLookupLanes(above, left), found.a);
        found.b = hn::IfThenElse(own, hn::TableLookupLanes(above, right), found.b);
        found.c = hn::IfThenElse(own, hn::TableLookupLanes(below, left), found.c);
        found.e = hn::IfThenElse(own, hn::TableLookupLanes(below, right), found.e);
        return bits_of(d, own, lanes32);
    }
};

/// The rows of a diagonal of the block, which meets every row and every column; the rest is gathered.
HWY_INLINE PackedCorners load_corners(const std::uint32_t* texels, const TexelCells& at,
                                      std::uint32_t lanes) {
    const D32 d;
    TexelWindows windows(texels, at);
    for (std::size_t first = 0; first < lanes32; first += block_side + 1) lanes &= ~windows.fill(first);
    const PackedCorners& t = windows.found;
    if (lanes == 0) return t;
    const auto rest = lanes_of(d, lanes, 0);
    const PackedCorners g = gather_corners(texels, at);
    return {hn::IfThenElse(rest, g.a, t.a), hn::IfThenElse(rest, g.b, t.b), hn::IfThenElse(rest, g.c, t.c),
            hn::IfThenElse(rest, g.e, t.e)};
}

#else

HWY_INLINE PackedCorners load_corners(const std::uint32_t* texels, const TexelCells& at, std::uint32_t) {
    return gather_corners(texels, at);
}

#endif  // HWY_MAX_BYTES >= 32

/// What the texture unit needs of 16 pixels, each of its own primitive: planes' values and how to scale them.
struct TextureInputs {
    alignas(64) std::uint32_t q[block_pixels], u[block_pixels], v[block_pixels];
    alignas(64) std::int32_t u_exponent[block_pixels],
        v_exponent[block_pixels], u_k[block_pixels], v_k[block_pixels];
    alignas(64) float slope[block_pixels];  ///< rho Q^2 2^16
};

/// A part of a block's coordinates, in vectors.
struct Coordinates {
    VF u, v;  ///< U W 2^e: at most 1024
    VI u_k, v_k;
};

/// One draw's texture as the lanes see it.
struct Sampler {
    const FastTexels& texels;
    const TextureState& state;
    int bits;

    const TexelLevel& base() const { return texels.texels.levels[0]; }

    /// u + k in 1/256 texels of the lanes' own levels, whose sides are 2^log2_size; u 2^.. at most 2^30.
    HWY_INLINE static VI coordinate(VF u, VI k, VI log2_size) {
        const I32 i;
        const F32 f;
        const auto shift = hn::Add(log2_size, hn::Set(i, 8));
        const auto scale = hn::BitCast(f, hn::ShiftLeft<23>(hn::Add(shift, hn::Set(i, 127))));
        const auto scaled = hn::Max(hn::Zero(f), hn::Min(hn::Mul(u, scale), hn::Set(f, 1073741824.0f)));
        return hn::Add(hn::ConvertTo(i, scaled), hn::Shl(k, shift));
    }

    /// Wraps texel indices of levels with `last` + 1 texels a side.
    HWY_INLINE static VI wrapped(Wrap wrap, VI index, VI last) {
        return wrap == Wrap::Repeat ? hn::And(index, last) : hn::Min(hn::Max(index, hn::Zero(I32())), last);
    }

    /// The lanes' levels: sides 2^log2_w x 2^log2_h, where they start.
    struct Level {
        VI log2_w, log2_h, first;
    };
    HWY_INLINE Level base_level() const {
        const I32 i;
        return {hn::Set(i, base().log2_width), hn::Set(i, base().log2_height), hn::Zero(i)};
    }
    HWY_INLINE Level level(VI index) const {
        const I32 i;
        const auto zero = hn::Zero(i);
        return {hn::Max(hn::Sub(hn::Set(i, base().log2_width), index), zero),
                hn::Max(hn::Sub(hn::Set(i, base().log2_height), index), zero),
                hn::GatherIndex(i, texels.first.data(), index)};
    }

    /// lookup() of gw/texels.h in the lanes' own levels; those outside `lanes` may come out as anything.
    HWY_INLINE TexelLanes lookup(const Coordinates& at, const Level& level, bool linear,
                                 std::uint32_t lanes) const {
        const I32 i;
        const D32 d;
        const auto one = hn::Set(i, 1);
        const auto last_x = hn::Sub(hn::Shl(one, level.log2_w), one),
                   last_y = hn::Sub(hn::Shl(one, level.log2_h), one);
        auto u = coordinate(at.u, at.u_k, level.log2_w), v = coordinate(at.v, at.v_k, level.log2_h);
        const auto row = [&](VI y) {
            return hn::Add(level.first, hn::Shl(wrapped(state.wrap_t, y, last_y), level.log2_w));
        };
        const auto column = [&](VI x) { return wrapped(state.wrap_s, x, last_x); };
        if (!linear) return fetch(texels, hn::Add(row(hn::ShiftRight<8>(v)), column(hn::ShiftRight<8>(u))));

        const auto half = hn::Set(i, 128), fraction = hn::Set(i, 255);
        u = hn::Sub(u, half), v = hn::Sub(v, half);
        const auto x = hn::ShiftRight<8>(u), y = hn::ShiftRight<8>(v);
        const TexelCells cells{column(x), column(hn::Add(x, one)), row(y), row(hn::Add(y, one))};
        const auto wx = hn::BitCast(d, hn::And(u, fraction)), wy = hn::BitCast(d, hn::And(v, fraction));
        if (!texels.packed.empty())
            return bilinear_bytes(load_corners(texels.packed.data(), cells, lanes), wx, wy);
        const TexelLanes a = fetch(texels, hn::Add(cells.upper, cells.left)),
                         b = fetch(texels, hn::Add(cells.upper, cells.right));
        const TexelLanes c = fetch(texels, hn::Add(cells.lower, cells.left)),
                         e = fetch(texels, hn::Add(cells.lower, cells.right));
        TexelLanes out;
        for (std::size_t k = 0; k < 4; ++k)
            out.channel[k] = bilinear_wide(a.channel[k], b.channel[k], c.channel[k], e.channel[k], wx, wy);
        return out;
    }
};

/// What rho is made of: the larger slope of each row and column. docs/manual.md, "Level of detail".
HWY_NOINLINE inline void store_slopes(const Sampler& s, const TexturePlanes& p, const Tile& tile, int bx,
                                      int by, std::uint32_t mask, float* slope) {
    const double scale_s = power_of_two(p.s.exponent + s.base().log2_width);
    const double scale_t = power_of_two(p.t.exponent + s.base().log2_height);
    const CoordinateSlope &u = p.s.slope, &v = p.t.slope;
    float row[block_side], column[block_side];
    for (int i = 0; i < block_side; ++i) {
        const int dx = tile.x + bx * block_side + i - p.slope_x,
                  dy = tile.y + by * block_side + i - p.slope_y;
        const double row_u = std::abs(u.a + double(u.k) * dy), row_v = std::abs(v.a + double(v.k) * dy);
        const double column_u = std::abs(u.b - double(u.k) * dx), column_v = std::abs(v.b - double(v.k) * dx);
        row[i] = static_cast<float>(std::max(row_u * scale_s, row_v * scale_t));
        column[i] = static_cast<float>(std::max(column_u * scale_s, column_v * scale_t));
    }
    for (; mask != 0; mask &= mask - 1) {
        const auto lane = std::size_t(std::countr_zero(mask));
        slope[lane] = std::max(row[lane / block_side], column[lane % block_side]);
    }
}

/// Puts the lanes of `mask`, which one primitive covers, into the inputs.
HWY_NOINLINE inline void texture_inputs(const Sampler& s, const TexturePlanes& p, const Tile& tile, int bx,
                                        int by, std::uint32_t mask, TextureInputs& out) {
    const D32 d;
    const I32 i32;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        const auto lanes = lanes_of(d, mask, i);
        const auto signed_lanes = hn::RebindMask(i32, lanes);
        hn::BlendedStore(wide_plane(p.q, at), lanes, d, out.q + i);
        hn::BlendedStore(wide_plane(p.s.plane, at), lanes, d, out.u + i);
        hn::BlendedStore(wide_plane(p.t.plane, at), lanes, d, out.v + i);
        hn::BlendedStore(hn::Set(i32, p.s.exponent), signed_lanes, i32, out.u_exponent + i);
        hn::BlendedStore(hn::Set(i32, p.t.exponent), signed_lanes, i32, out.v_exponent + i);
        hn::BlendedStore(hn::Set(i32, p.s.k), signed_lanes, i32, out.u_k + i);
        hn::BlendedStore(hn::Set(i32, p.t.k), signed_lanes, i32, out.v_k + i);
    }
    if (needs_rho(s.state)) store_slopes(s, p, tile, bx, by, mask, out.slope);
}

/// choose_level() of gw/texels.h, lane by lane.
struct LevelLanes {
    hn::Mask<I32> magnify;
    VI level, next;
    V32 weight;
};

HWY_INLINE LevelLanes choose_levels(const Sampler& s, VF rho) {
    const I32 i;
    const auto bits = hn::BitCast(i, rho);
    const bool later =
        s.state.mag_filter == MagFilter::Linear && (s.state.min_filter == MinFilter::NearestMipmapNearest ||
                                                    s.state.min_filter == MinFilter::NearestMipmapLinear);
    LevelLanes out{hn::Not(hn::Gt(bits, hn::Set(i, later ? 0x3FB504F3 : 0x3F800000))), hn::Zero(i),
                   hn::Zero(i), hn::Zero(D32())};
    const auto last = hn::Set(i, int(s.texels.texels.levels.size()) - 1);
    const auto level_from = [&](int origin) { return hn::ShiftRight<23>(hn::Sub(bits, hn::Set(i, origin))); };
    switch (s.state.min_filter) {
        case MinFilter::Nearest:
        case MinFilter::Linear: break;
        case MinFilter::NearestMipmapNearest:
        case MinFilter::LinearMipmapNearest:
            out.level = hn::Min(hn::Max(level_from(0x3F3504F4), hn::Zero(i)), last);
            break;
        case MinFilter::NearestMipmapLinear:
        case MinFilter::LinearMipmapLinear: {
            const auto level = level_from(0x3F800000);
            const auto inside = hn::Lt(level, last);
            const auto mantissa = hn::And(hn::ShiftRight<15>(bits), hn::Set(i, 255));
            const auto weight = hn::GatherIndex(D32(), mantissa_levels().data(), mantissa);
            out.level = hn::Min(hn::Max(level, hn::Zero(i)), last);
            out.weight = hn::IfThenElseZero(hn::RebindMask(D32(), inside), weight);
            break;
        }
    }
    out.level = hn::IfThenZeroElse(out.magnify, out.level);
    out.weight = hn::IfThenZeroElse(hn::RebindMask(D32(), out.magnify), out.weight);
    out.next = hn::Min(hn::Add(out.level, hn::Set(i, 1)), last);
    return out;
}

HWY_INLINE bool is_linear(MinFilter filter) {
    return filter == MinFilter::Linear || filter == MinFilter::LinearMipmapNearest ||
           filter == MinFilter::LinearMipmapLinear;
}

/// The lanes' texels at one level each, magnified and minified lanes by their own filters.
HWY_INLINE TexelLanes sample_level(const Sampler& s, const Coordinates& at, VI index, hn::Mask<I32> magnify,
                                   std::uint32_t lanes) {
    const bool small = is_linear(s.state.min_filter), large = s.state.mag_filter == MagFilter::Linear;
    const Sampler::Level level = s.level(index);
    TexelLanes out = s.lookup(at, level, small, lanes);
    if (small == large) return out;
    const TexelLanes other = s.lookup(at, level, large, lanes);
    const auto chosen = hn::RebindMask(D32(), magnify);
    for (std::size_t k = 0; k < 4; ++k)
        out.channel[k] = hn::IfThenElse(chosen, other.channel[k], out.channel[k]);
    return out;
}

/// between_levels() of gw/texels.h.
HWY_INLINE void mix_levels(TexelLanes& a, const TexelLanes& b, V32 weight) {
    const I32 i;
    const auto f = hn::BitCast(i, weight), half = hn::Set(i, 128);
    for (std::size_t k = 0; k < 4; ++k) {
        const auto from = hn::BitCast(i, a.channel[k]), to = hn::BitCast(i, b.channel[k]);
        const auto step = hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(to, from), f), half));
        a.channel[k] = hn::BitCast(D32(), hn::Add(from, step));
    }
}

HWY_INLINE VF rho_lanes(VF slope, VF w) {
    return hn::Mul(hn::Mul(slope, hn::Mul(w, w)), hn::Set(F32(), 1.0f / 65536));
}

/// Divides: what depends on the pixels and the texture's size, but not on its texels.
HWY_NOINLINE inline void divide_block(const Sampler& s, const TextureInputs& in, TextureLanes& out) {
    const D32 u;
    const I32 d;
    const F32 f;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto w = hn::Div(hn::Set(f, 1.0f), to_floats(hn::Load(u, in.q + i)));
        const auto over = [&](const std::uint32_t* p, const std::int32_t* exponent) {
            const auto biased = hn::Add(hn::Load(d, exponent + i), hn::Set(d, 127));
            return hn::Mul(hn::Mul(to_floats(hn::Load(u, p + i)), w),
                           hn::BitCast(f, hn::ShiftLeft<23>(biased)));
        };
        hn::Store(over(in.u, in.u_exponent), f, out.u + i);
        hn::Store(over(in.v, in.v_exponent), f, out.v + i);
        hn::Store(hn::Load(d, in.u_k + i), d, out.u_k + i);
        hn::Store(hn::Load(d, in.v_k + i), d, out.v_k + i);
        if (!needs_rho(s.state)) continue;
        hn::Store(rho_lanes(hn::Load(f, in.slope + i), w), f, out.rho + i);
    }
}

/// The same where one primitive covers the lanes of `mask`.
HWY_NOINLINE inline void divide_block(const Sampler& s, const TexturePlanes& p, const Tile& tile, int bx,
                                      int by, std::uint32_t mask, TextureLanes& out) {
    const I32 d;
    const F32 f;
    alignas(64) float slope[block_pixels] = {};
    if (needs_rho(s.state)) store_slopes(s, p, tile, bx, by, mask, slope);
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        const auto w = reciprocal_lanes(p.q, at);
        const auto over = [&](const TexturePlane& t) {
            return hn::Mul(hn::Mul(to_floats(wide_plane(t.plane, at)), w),
                           hn::Set(f, static_cast<float>(power_of_two(t.exponent))));
        };
        hn::Store(over(p.s), f, out.u + i), hn::Store(over(p.t), f, out.v + i);
        hn::Store(hn::Set(d, p.s.k), d, out.u_k + i), hn::Store(hn::Set(d, p.t.k), d, out.v_k + i);
        if (needs_rho(s.state)) hn::Store(rho_lanes(hn::Load(f, slope + i), w), f, out.rho + i);
    }
}

/// The texels of the lanes of `mask`; the others may come out as anything.
HWY_NOINLINE inline void sample_block(const Sampler& s, const TextureLanes& in, std::uint32_t mask,
                                      ColorBlock& out) {
    const I32 d;
    const F32 f;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Coordinates at{hn::Load(f, in.u + i), hn::Load(f, in.v + i), hn::Load(d, in.u_k + i),
                             hn::Load(d, in.v_k + i)};
        const std::uint32_t lanes = mask >> i & ((1u << lanes32) - 1);
        TexelLanes texel;
        if (!needs_rho(s.state)) {
            texel = s.lookup(at, s.base_level(), s.state.mag_filter == MagFilter::Linear, lanes);
        } else {
            const LevelLanes l = choose_levels(s, hn::Load(f, in.rho + i));
            texel = sample_level(s, at, l.level, l.magnify, lanes);
            const auto mixed = hn::Gt(hn::BitCast(d, l.weight), hn::Zero(d));
            if (!hn::AllFalse(d, mixed))
                mix_levels(texel, sample_level(s, at, l.next, l.magnify, lanes), l.weight);
        }
        for (std::size_t k = 0; k < 4; ++k) store16(texel.channel[k], out.channel[k] + i);
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
