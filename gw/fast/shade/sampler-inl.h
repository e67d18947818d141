// Looks up a texture at the coordinates of 16 pixels: addressing, and the filters of one level.
// docs/manual.md, "Textures"; scalar twin: gw/stages/texels.cpp. Does not choose levels. Included
// once per Highway target.
#if defined(GW_FAST_SAMPLER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SAMPLER_INL_H_
#undef GW_FAST_SAMPLER_INL_H_
#else
#define GW_FAST_SAMPLER_INL_H_
#endif

#include "gw/base/powers.h"
#include "gw/fast/shade/texels-inl.h"

#include <algorithm>
#include <bit>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// A part of a block's coordinates, in vectors.
struct Coordinates {
    VF u, v;  ///< U W 2^e: at most 1024
    VI u_k, v_k;
};

/// One draw's texture, for look-ups in vectors. `Found` is what a look-up gives: TexelWords for 8
/// bits, else TexelLanes.
struct Sampler {
    const FastTexels& texels;
    const TexelPairs* pairs;  ///< null: more than 8 bits, or no filter is linear
    const TextureState& state;
    int bits;

    bool has_bytes() const { return !texels.texels.packed.empty(); }
    const TexelLevel& base() const { return texels.texels.levels[0]; }
    LevelRange levels() const { return {0, int(texels.texels.levels.size()) - 1}; }

    /// u + k in 1/256 texels of the lanes' own levels, whose sides are 2^log2_size; the scaled u is
    /// at most 2^30.
    HWY_INLINE static VI coordinate(VF u, VI k, VI log2_size) {
        const I32 i;
        const F32 f;
        const auto shift = hn::Add(log2_size, hn::Set(i, 8));
        const auto scale = hn::BitCast(f, hn::ShiftLeft<23>(hn::Add(shift, hn::Set(i, 127))));
        const auto scaled =
            hn::Max(hn::Zero(f), hn::Min(hn::Mul(u, scale), hn::Set(f, 1073741824.0f)));
        return hn::Add(hn::ConvertTo(i, scaled), hn::Shl(k, shift));
    }

    /// Wraps texel indices of levels with `last` + 1 texels a side.
    HWY_INLINE static VI wrapped(Wrap wrap, VI index, VI last) {
        return wrap == Wrap::Repeat ? hn::And(index, last)
                                    : hn::Min(hn::Max(index, hn::Zero(I32())), last);
    }

    /// One axis of a bilinear filter's place among the pairs.
    struct Place {
        VI index;
        V32 weight;  ///< of the next texel, in 256ths
    };
    /// `position` is in 1/256 texels from the centre of the first texel.
    HWY_INLINE static Place place(Wrap wrap, VI position, VI size) {
        const I32 i;
        if (wrap != Wrap::BorderClamp) {
            const auto texel = hn::ShiftRight<8>(position);
            return {wrapped(wrap, texel, hn::Sub(size, hn::Set(i, 1))),
                    weight(wrap, position, texel)};
        }
        // At most half a texel beyond the sides, from the centre of the border's first texel.
        const auto last = hn::Add(hn::ShiftLeft<8>(size), hn::Set(i, 128));
        const auto from_border =
            hn::Min(hn::Max(hn::Add(position, hn::Set(i, 256)), hn::Set(i, 128)), last);
        return {hn::ShiftRight<8>(from_border),
                hn::BitCast(D32(), hn::And(from_border, hn::Set(i, 255)))};
    }
    /// The index of a pair of a level that is 2^log2_width wide, in the level's pairs.
    HWY_INLINE static VI pair_index(const TexelPairs& pairs, VI row, VI column, VI log2_width) {
        auto start = hn::Add(hn::Shl(row, log2_width), row);
        if (pairs.how.wrap_s == Wrap::BorderClamp) start = hn::Add(start, row);
        return hn::Add(start, column);
    }

    /// The weight of a texel's right or upper neighbour, in 256ths. Beyond a clamped side both
    /// texels are the first one, so any weight gives the same mean.
    HWY_INLINE static V32 weight(Wrap wrap, VI position, VI texel) {
        const I32 i;
        auto fraction = hn::And(position, hn::Set(i, 255));
        if (wrap != Wrap::Repeat)
            fraction = hn::IfThenZeroElse(hn::Lt(texel, hn::Zero(i)), fraction);
        return hn::BitCast(D32(), fraction);
    }

    /// The lanes' levels: sides 2^log2_w x 2^log2_h, and the starts of their texels and pairs.
    struct Level {
        VI log2_w, log2_h, first, first_pair;
    };
    HWY_INLINE Level base_level() const {
        const I32 i;
        return {hn::Set(i, base().log2_width), hn::Set(i, base().log2_height), hn::Zero(i),
                hn::Zero(i)};
    }
    HWY_INLINE Level level(VI index) const {
        const I32 i;
        const auto zero = hn::Zero(i);
        if (const int one = hn::GetLane(index); hn::AllTrue(i, hn::Eq(index, hn::Set(i, one))))
            return level_of_all(one);
        const auto first = hn::GatherIndex(i, texels.first.data(), index);
        return {hn::Max(hn::Sub(hn::Set(i, base().log2_width), index), zero),
                hn::Max(hn::Sub(hn::Set(i, base().log2_height), index), zero), first,
                pairs ? hn::GatherIndex(i, pairs->first.data(), index) : first};
    }

    /// lookup() of gw/stages/texels.h in the lanes' own levels.
    template <class Found>
    HWY_INLINE Found lookup(const Coordinates& at, const Level& level, bool linear) const {
        const auto u = coordinate(at.u, at.u_k, level.log2_w),
                   v = coordinate(at.v, at.v_k, level.log2_h);
        if (linear) return mean<Found>(u, v, level);
        const auto row = hn::Shl(row_of(level, hn::ShiftRight<8>(v)), level.log2_w);
        return fetch<Found>(
            hn::Add(hn::Add(level.first, row), column_of(level, hn::ShiftRight<8>(u))));
    }

private:
    /// Without gathers, which are slow.
    HWY_INLINE Level level_of_all(int index) const {
        const I32 i;
        const auto k = std::size_t(index);
        return {hn::Set(i, std::max(base().log2_width - index, 0)),
                hn::Set(i, std::max(base().log2_height - index, 0)), hn::Set(i, texels.first[k]),
                hn::Set(i, pairs ? pairs->first[k] : texels.first[k])};
    }
    template <class Found>
    HWY_INLINE Found fetch(VI index) const {
        if constexpr (std::is_same_v<Found, TexelWords>)
            return fetch_bytes(texels, index);
        else
            return fetch_wide(texels, index);
    }
    HWY_INLINE VI column_of(const Level& level, VI x) const {
        const auto one = hn::Set(I32(), 1);
        return wrapped(state.wrap_s, x, hn::Sub(hn::Shl(one, level.log2_w), one));
    }
    HWY_INLINE VI row_of(const Level& level, VI y) const {
        const auto one = hn::Set(I32(), 1);
        return wrapped(state.wrap_t, y, hn::Sub(hn::Shl(one, level.log2_h), one));
    }
    /// The mean of the four texels around a position.
    template <class Found>
    HWY_INLINE Found mean(VI u, VI v, const Level& level) const {
        const auto half = hn::Set(I32(), 128);
        u = hn::Sub(u, half);
        v = hn::Sub(v, half);
        if constexpr (std::is_same_v<Found, TexelWords>)
            return mean_of_bytes(u, v, level);
        else
            return mean_of_wide(u, v, level);
    }
    HWY_INLINE TexelWords mean_of_bytes(VI u, VI v, const Level& level) const {
        const auto one = hn::Set(I32(), 1);
        const Place s = place(pairs->how.wrap_s, u, hn::Shl(one, level.log2_w)),
                    t = place(pairs->how.wrap_t, v, hn::Shl(one, level.log2_h));
        const auto index =
            hn::Add(level.first_pair, pair_index(*pairs, t.index, s.index, level.log2_w));
        return bilinear_bytes(load_corners(pairs->pairs.data(), index), s.weight, t.weight);
    }
    HWY_INLINE TexelLanes mean_of_wide(VI u, VI v, const Level& level) const {
        const auto one = hn::Set(I32(), 1);
        const auto x = hn::ShiftRight<8>(u), y = hn::ShiftRight<8>(v);
        const auto wx = weight(state.wrap_s, u, x), wy = weight(state.wrap_t, v, y);
        const auto left = column_of(level, x), low = row_of(level, y);
        const auto right = column_of(level, hn::Add(x, one)), high = row_of(level, hn::Add(y, one));
        const auto start = [&](VI row) { return hn::Add(level.first, hn::Shl(row, level.log2_w)); };
        return mean_of_corners(left, right, start(low), start(high), wx, wy);
    }
    HWY_INLINE TexelLanes mean_of_corners(VI left, VI right, VI low, VI high, V32 wx,
                                          V32 wy) const {
        const TexelLanes a = fetch_wide(texels, hn::Add(low, left)),
                         b = fetch_wide(texels, hn::Add(low, right));
        const TexelLanes c = fetch_wide(texels, hn::Add(high, left)),
                         e = fetch_wide(texels, hn::Add(high, right));
        TexelLanes out;
        for (std::size_t k = 0; k < 4; ++k)
            out.channel[k] =
                bilinear_wide(a.channel[k], b.channel[k], c.channel[k], e.channel[k], wx, wy);
        return out;
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
