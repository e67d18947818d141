// Texels of textures of 8 bits that have two dimensions, of any size and wrap, at the coordinates of 16
// pixels. docs/manual/texture.md; scalar twins: gw/stages/texels.cpp, any_position() of
// gw/stages/perspective.h. Does not choose levels. Included once per Highway target.
#if defined(GW_FAST_SIZED_SAMPLER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SIZED_SAMPLER_INL_H_
#undef GW_FAST_SIZED_SAMPLER_INL_H_
#else
#define GW_FAST_SIZED_SAMPLER_INL_H_
#endif

#include "gw/fast/shade/fetched-inl.h"
#include "gw/fast/shade/positions-inl.h"
#include "gw/stages/perspective.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// What Sampler is for textures of OpenGL 1.1. Coordinates may have any sign and size.
struct SizedSampler {
    const FoldedTexels& folded;
    const TextureState& state;
    const Texels& texels = folded.texels;

    LevelRange levels() const { return level_range(state, int(texels.levels.size())); }

    /// The lanes' levels.
    struct Level {
        VI width, height, first, index;
    };
    HWY_INLINE Level base_level() const { return level_of_all(levels().base); }
    HWY_INLINE Level level(VI index) const {
        const I32 d;
        Level out = level_of_all(hn::GetLane(index));
        for (auto rest = hn::Not(hn::Eq(out.index, index)); !hn::AllFalse(d, rest);
             rest = hn::Not(hn::Eq(out.index, index))) {
            alignas(64) std::int32_t lanes[lanes32];
            hn::Store(index, d, lanes);
            const Level other = level_of_all(lanes[hn::FindFirstTrue(d, rest)]);
            const auto same = hn::Eq(other.index, index);
            out = {hn::IfThenElse(same, other.width, out.width),
                   hn::IfThenElse(same, other.height, out.height),
                   hn::IfThenElse(same, other.first, out.first),
                   hn::IfThenElse(same, other.index, out.index)};
        }
        return out;
    }

    /// lookup() of gw/stages/texels.h in the lanes' own levels.
    template <class Found>
    HWY_INLINE Found lookup(const Coordinates& at, const Level& level, bool linear) const {
        const Wrap wrap_s = folded.how.wrap_s, wrap_t = folded.how.wrap_t;
        const VI u = positions(at.u, at.u_k, level.width, wrap_s),
                 v = positions(at.v, at.v_k, level.height, wrap_t);
        if (!linear)
            return words_of(texel(nearest_index(wrap_s, hn::ShiftRight<8>(u), level.width),
                                  nearest_index(wrap_t, hn::ShiftRight<8>(v), level.height),
                                  level));
        const I32 d;
        const auto one = hn::Set(d, 1), fraction = hn::Set(d, 255);
        const VI us = from_first_centre(wrap_s, u, level.width),
                 vs = from_first_centre(wrap_t, v, level.height);
        const VI i = hn::ShiftRight<8>(us), j = hn::ShiftRight<8>(vs);
        const VI left = linear_index(wrap_s, i, level.width),
                 right = linear_index(wrap_s, hn::Add(i, one), level.width),
                 low = linear_index(wrap_t, j, level.height),
                 high = linear_index(wrap_t, hn::Add(j, one), level.height);
        return bilinear_bytes({texel(left, low, level), texel(right, low, level),
                               texel(left, high, level), texel(right, high, level)},
                              hn::BitCast(D32(), hn::And(us, fraction)),
                              hn::BitCast(D32(), hn::And(vs, fraction)));
    }

    /// PixelSampler::position() of gw/fast/shade/texture_by_pixel.cpp, modulo the size under Repeat.
    HWY_INLINE int position(float u, std::int32_t k, int size, Wrap wrap) const {
        if (texels.any_size || wrap == Wrap::MirroredRepeat)
            return any_position(double(u), 0, k, size, wrap);
        constexpr float limit = 1073741824.0f;
        const int all = 256 * size;
        const int n = static_cast<int>(std::floor(std::clamp(u * float(all), -limit, limit)));
        return wrap == Wrap::Repeat ? n & (all - 1) : static_cast<int>(n + std::int64_t{k} * all);
    }

private:
    HWY_INLINE Level level_of_all(int index) const {
        const I32 d;
        const TexelLevel& level = texels.levels[std::size_t(index)];
        return {hn::Set(d, level.width), hn::Set(d, level.height), hn::Set(d, int(level.first)),
                hn::Set(d, index)};
    }

    /// position() of the lanes; under a repetition 0 may be the period.
    HWY_INLINE VI positions(VF u, VI k, VI size, Wrap wrap) const {
        if (texels.any_size || wrap == Wrap::MirroredRepeat) return any_positions(u, k, size, wrap);
        const I32 d;
        const F32 f;
        const auto all = hn::ShiftLeft<8>(size);
        const auto limit = hn::Set(f, 1073741824.0f);
        const auto scaled = hn::Floor(hn::Mul(u, hn::ConvertTo(f, all)));
        const auto n = hn::ConvertTo(d, hn::Max(hn::Neg(limit), hn::Min(scaled, limit)));
        if (wrap == Wrap::Repeat) return hn::And(n, hn::Sub(all, hn::Set(d, 1)));
        return hn::Add(n, hn::Mul(k, all));
    }
    HWY_NOINLINE VI any_positions(VF u, VI k, VI size, Wrap wrap) const {
        const I32 d;
        alignas(64) float us[lanes32];
        alignas(64) std::int32_t ks[lanes32], sizes[lanes32], found[lanes32];
        hn::Store(u, F32(), us);
        hn::Store(k, d, ks);
        hn::Store(size, d, sizes);
        if (!positions_by_doubles(us, ks, sizes, wrap, found))
            for (std::size_t i = 0; i < lanes32; ++i)
                found[i] = position(us[i], ks[i], sizes[i], wrap);
        return hn::Load(d, found);
    }
#if HWY_HAVE_FLOAT64
    /// False if a position is too large for it.
    HWY_INLINE static bool positions_by_doubles(const float* u, const std::int32_t* k,
                                                const std::int32_t* size, Wrap wrap,
                                                std::int32_t* found) {
        const D64 d;
        const I32ForD64 i32;
        const hn::Rebind<float, D64> f;
        for (std::size_t i = 0; i < lanes32; i += hn::Lanes(d)) {
            const auto texels = hn::PromoteTo(d, hn::ShiftLeft<8>(hn::Load(i32, size + i)));
            const auto from = hn::Floor(hn::Mul(hn::PromoteTo(d, hn::Load(f, u + i)), texels));
            const auto n = hn::Add(from, hn::Mul(hn::PromoteTo(d, hn::Load(i32, k + i)), texels));
            if (!hn::AllTrue(d, hn::Lt(hn::Abs(n), hn::Set(d, 0x1p50)))) return false;
            hn::Store(hn::DemoteTo(i32, folded_position(n, texels, wrap)), i32, found + i);
        }
        return true;
    }
#else
    HWY_INLINE static bool positions_by_doubles(const float*, const std::int32_t*,
                                                const std::int32_t*, Wrap, std::int32_t*) {
        return false;
    }
#endif

    /// FoldedTexels::at() of indices at most one outside of the level.
    HWY_INLINE V32 texel(VI i, VI j, const Level& level) const {
        const I32 d;
        const auto fetch = [&](VI x, VI y) {
            return hn::GatherIndex(D32(), texels.packed.data(),
                                   hn::Add(level.first, hn::Add(hn::Mul(y, level.width), x)));
        };
        if (!reaches_outside(folded.how.wrap_s) && !reaches_outside(folded.how.wrap_t))
            return fetch(i, j);
        const auto zero = hn::Zero(d), one = hn::Set(d, 1);
        const VI x = within(i, zero, hn::Sub(level.width, one)),
                 y = within(j, zero, hn::Sub(level.height, one));
        const auto inside = hn::And(hn::Eq(x, i), hn::Eq(y, j));
        const V32 found = fetch(x, y);
        if (hn::AllTrue(d, inside)) return found;
        return hn::IfThenElse(hn::RebindMask(D32(), inside), found, outer(i, j, level));
    }
    HWY_NOINLINE V32 outer(VI i, VI j, const Level& level) const {
        const I32 d;
        alignas(64) std::int32_t x[lanes32], y[lanes32], index[lanes32];
        alignas(64) std::uint32_t found[lanes32];
        hn::Store(i, d, x);
        hn::Store(j, d, y);
        hn::Store(level.index, d, index);
        for (std::size_t k = 0; k < lanes32; ++k)
            found[k] = folded.at(texels.levels[std::size_t(index[k])], x[k], y[k], 0);
        return hn::Load(D32(), found);
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
