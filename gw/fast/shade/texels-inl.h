// Texels for 16 pixels, fetched and filtered. docs/manual.md, "Textures";
// scalar twin: gw/stages/texels.cpp. Does not know coordinates or levels. Included once per Highway
// target.
#if defined(GW_FAST_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TEXELS_INL_H_
#undef GW_FAST_TEXELS_INL_H_
#else
#define GW_FAST_TEXELS_INL_H_
#endif

#include "gw/fast/plan/texels.h"
#include "gw/fast/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

using VI = hn::Vec<I32>;
using VF = hn::Vec<F32>;

/// Four channels of one texel per lane.
struct TexelLanes {
    V32 channel[4];
};

HWY_INLINE TexelLanes fetch_wide(const FastTexels& t, VI index) {
    const D32 d;
    TexelLanes out;
    const auto* base = reinterpret_cast<const std::uint32_t*>(t.texels.wide.data());
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

/// bilinear() of gw/stages/texels.h, more than 8 bits.
HWY_INLINE V32 bilinear_wide(V32 a, V32 b, V32 c, V32 e, V32 wx, V32 wy) {
    const D32 d;
    const auto whole = hn::Set(d, 256u);
    const auto mix = [&](V32 p, V32 q, V32 w) {
        return hn::Add(hn::Mul(p, hn::Sub(whole, w)), hn::Mul(q, w));
    };
    return hn::ShiftRight<16>(hn::Add(mix(mix(a, b, wx), mix(c, e, wx), wy), hn::Set(d, 1u << 15)));
}

/// Four packed texels of each lane: a b, and c e in the row above.
struct PackedCorners {
    V32 a, b, c, e;
};

/// One texel per lane, two channels in the halves of each: R below B, G below A.
struct TexelWords {
    V32 rb, ga;

    HWY_INLINE TexelLanes channels() const {
        const auto low = hn::Set(D32(), 0xFFFFu);
        return {
            {hn::And(rb, low), hn::And(ga, low), hn::ShiftRight<16>(rb), hn::ShiftRight<16>(ga)}};
    }
};

HWY_INLINE TexelWords words_of(V32 packed) {
    const auto bytes = hn::Set(D32(), 0x00FF00FFu);
    return {hn::And(packed, bytes), hn::And(hn::ShiftRight<8>(packed), bytes)};
}
HWY_INLINE TexelWords fetch_bytes(const FastTexels& t, VI index) {
    return words_of(hn::GatherIndex(D32(), t.texels.packed.data(), index));
}

#if HWY_TARGET == HWY_SCALAR

/// bilinear() of gw/stages/texels.h, 8 bits, one channel.
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

HWY_INLINE TexelWords bilinear_bytes(const PackedCorners& t, V32 wx, V32 wy) {
    const auto byte = hn::Set(D32(), 255u);
    V32 channel[4];
    for (std::size_t k = 0; k < 4; ++k) {
        const auto of = [&](V32 v) { return hn::And(hn::ShiftRightSame(v, int(8 * k)), byte); };
        channel[k] = bilinear_byte(of(t.a), of(t.b), of(t.c), of(t.e), wx, wy);
    }
    return {hn::Or(channel[0], hn::ShiftLeft<16>(channel[2])),
            hn::Or(channel[1], hn::ShiftLeft<16>(channel[3]))};
}

#else

/// bilinear() of gw/stages/texels.h, 8 bits, for two channels. Every product is a rounding 15-bit
/// one. Texels are scaled by 64, weights (of 256) by 128.
HWY_INLINE V32 bilinear_halves(V32 a, V32 b, V32 c, V32 e, V32 x, V32 y) {
    const hn::Repartition<std::int16_t, D32> h;
    const auto s = [&](V32 v) { return hn::BitCast(h, v); };
    const auto mix = [&](auto p, auto q, V32 w) {
        return hn::Add(p, hn::MulFixedPoint15(hn::Sub(q, p), s(w)));
    };
    const auto t = mix(mix(s(a), s(b), x), mix(s(c), s(e), x), y);
    return hn::BitCast(D32(), hn::ShiftRight<6>(hn::Add(t, hn::Set(h, std::int16_t{32}))));
}

HWY_INLINE TexelWords bilinear_bytes(const PackedCorners& t, V32 wx, V32 wy) {
    const auto bytes = hn::Set(D32(), 0x3FC03FC0u);
    const auto even = [&](V32 v) { return hn::And(hn::ShiftLeft<6>(v), bytes); };
    const auto odd = [&](V32 v) { return hn::And(hn::ShiftRight<2>(v), bytes); };
    const auto both = [&](V32 w) { return hn::Or(hn::ShiftLeft<7>(w), hn::ShiftLeft<23>(w)); };
    const auto x = both(wx), y = both(wy);
    return {bilinear_halves(even(t.a), even(t.b), even(t.c), even(t.e), x, y),
            bilinear_halves(odd(t.a), odd(t.b), odd(t.c), odd(t.e), x, y)};
}

#endif  // HWY_TARGET == HWY_SCALAR

/// between_levels() of gw/stages/texels.h.
HWY_INLINE TexelLanes between_levels(const TexelLanes& a, const TexelLanes& b, V32 weight) {
    const I32 i;
    const auto f = hn::BitCast(i, weight), half = hn::Set(i, 128);
    TexelLanes out;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto from = hn::BitCast(i, a.channel[k]), to = hn::BitCast(i, b.channel[k]);
        const auto step = hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(to, from), f), half));
        out.channel[k] = hn::BitCast(D32(), hn::Add(from, step));
    }
    return out;
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE TexelWords between_levels(const TexelWords& a, const TexelWords& b, V32 weight) {
    const TexelLanes t = between_levels(a.channels(), b.channels(), weight);
    return {hn::Or(t.channel[0], hn::ShiftLeft<16>(t.channel[2])),
            hn::Or(t.channel[1], hn::ShiftLeft<16>(t.channel[3]))};
}

#else

/// The same of bytes: (b - a) weight is a rounding 15-bit product, if the difference is scaled by 128.
HWY_INLINE TexelWords between_levels(const TexelWords& a, const TexelWords& b, V32 weight) {
    const hn::Repartition<std::int16_t, D32> h;
    const auto f = hn::BitCast(h, hn::Or(weight, hn::ShiftLeft<16>(weight)));
    const auto mix = [&](V32 from, V32 to) {
        const auto p = hn::BitCast(h, from), q = hn::BitCast(h, to);
        const auto step = hn::MulFixedPoint15(hn::ShiftLeft<7>(hn::Sub(q, p)), f);
        return hn::BitCast(D32(), hn::Add(p, step));
    };
    return {mix(a.rb, b.rb), mix(a.ga, b.ga)};
}

#endif  // HWY_TARGET == HWY_SCALAR

/// The texels of `b` in the lanes of `mask`.
HWY_INLINE TexelLanes chosen(hn::Mask<D32> mask, const TexelLanes& b, const TexelLanes& a) {
    TexelLanes out;
    for (std::size_t k = 0; k < 4; ++k)
        out.channel[k] = hn::IfThenElse(mask, b.channel[k], a.channel[k]);
    return out;
}
HWY_INLINE TexelWords chosen(hn::Mask<D32> mask, const TexelWords& b, const TexelWords& a) {
    return {hn::IfThenElse(mask, b.rb, a.rb), hn::IfThenElse(mask, b.ga, a.ga)};
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE PackedCorners load_corners(const TexelPair* pairs, VI index) {
    const D32 d;
    const TexelPair* t = pairs + hn::GetLane(index);
    return {hn::Set(d, t[0].lower), hn::Set(d, t[1].lower), hn::Set(d, t[0].upper),
            hn::Set(d, t[1].upper)};
}

#else

/// Two adjacent pairs for every fourth pixel, pixel after pixel.
template <std::size_t lanes>
HWY_INLINE hn::Vec<hn::FixedTag<std::uint32_t, lanes> > every_fourth(const TexelPair* pairs,
                                                                     const std::int32_t* index) {
    const hn::FixedTag<std::uint32_t, lanes> d;
    if constexpr (lanes == 4)
        return hn::LoadU(d, &pairs[*index].lower);
    else
        return hn::Combine(d, every_fourth<lanes / 2>(pairs, index + lanes / 2),
                           every_fourth<lanes / 2>(pairs, index));
}

/// The pairs at `index` and the next ones, transposed in every 128 bits: a vector for each corner.
HWY_INLINE PackedCorners load_corners(const TexelPair* pairs, VI index) {
    const D32 d;
    const hn::Repartition<std::uint64_t, D32> two;
    alignas(64) std::int32_t at[lanes32];
    hn::Store(index, I32(), at);
    const auto pixels = [&](std::size_t i) { return every_fourth<lanes32>(pairs, at + i); };
    const auto low = [&](V32 a, V32 b) { return hn::BitCast(two, hn::InterleaveLower(d, a, b)); };
    const auto high = [&](V32 a, V32 b) { return hn::BitCast(two, hn::InterleaveUpper(d, a, b)); };
    const V32 p0 = pixels(0), p1 = pixels(1), p2 = pixels(2), p3 = pixels(3);
    const auto ac01 = low(p0, p1), ac23 = low(p2, p3), be01 = high(p0, p1), be23 = high(p2, p3);
    return {hn::BitCast(d, hn::InterleaveLower(two, ac01, ac23)),
            hn::BitCast(d, hn::InterleaveLower(two, be01, be23)),
            hn::BitCast(d, hn::InterleaveUpper(two, ac01, ac23)),
            hn::BitCast(d, hn::InterleaveUpper(two, be01, be23))};
}

#endif  // HWY_TARGET == HWY_SCALAR

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
