// Texels for 16 pixels: fetched from where they stand, in windows where pixels side by side look at texels
// side by side, and filtered. docs/manual.md, "Textures"; scalar twin: gw/texels.cpp. Does not know
// coordinates or levels. Included once per Highway target.
#if defined(GW_FAST_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TEXELS_INL_H_
#undef GW_FAST_TEXELS_INL_H_
#else
#define GW_FAST_TEXELS_INL_H_
#endif

#include "gw/fast/planes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

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

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
