// Look-ups of a block in textures that need r, but for cubes: volumes and depths, at one level.
// docs/manual/texture.md, "Textures with r"; scalar twin: gw/stages/textures/layers.cpp. Included once per
// Highway target.
#if defined(GW_FAST_WITH_R_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_WITH_R_INL_H_
#undef GW_FAST_WITH_R_INL_H_
#else
#define GW_FAST_WITH_R_INL_H_
#endif

#include "gw/fast/shade/fetched-inl.h"
#include "gw/stages/tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

HWY_INLINE bool looks_up_with_r(const TextureState& s, const Texels& texels,
                                const TexturePlanes& p) {
    const auto fits = [](const TexturePlane& t) { return std::abs(t.exponent) <= 100; };
    const bool has_one_level = s.shadow_compare || (!needs_rho(s) && !texels.packed.empty());
    return texels.with_r && !texels.cube && has_one_level && fits(p.s) && fits(p.t) && fits(p.r);
}

/// A block of one primitive.
class WithRBlock {
public:
    HWY_INLINE WithRBlock(const TexturePlanes& p, const TexelValues& values,
                          const TextureState& state, const ResolvedTexture& resolved,
                          const Texels& texels)
        : values_(values),
          state_(state),
          texels_(texels),
          how_(addressing(state, texels, resolved.border_color)),
          folded_{texels, how_},
          level_(texels.levels[std::size_t(level_range(state, int(texels.levels.size())).base)]) {
        divide(p);
    }

    HWY_INLINE void look_up(std::uint32_t mask, ColorBlock& out) {
        const bool linear = is_linear(state_, true);
        for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
            const auto lane = std::size_t(std::countr_zero(rest));
            if (values_.q[lane] < 1)
                found_.put_white(lane);
            else if (texels_.dimensions == 3)
                fetch_layers(lane, linear);
            else
                fetch(lane, linear, 0, found_.first);
        }
        found_.filter(mask, out);
    }
    /// r against the depth of the nearest texel.
    HWY_INLINE void compare_lanes_of(std::uint32_t mask, ColorBlock& out) const {
        const auto one = static_cast<std::uint16_t>(max_of_bits(texels_.bits));
        const Rgba lit = completed(texels_.format, {one, one, one, one}, one),
                   dark = completed(texels_.format, {}, one);
        for (; mask != 0; mask &= mask - 1) {
            const auto lane = std::size_t(std::countr_zero(mask));
            const bool is_white = values_.q[lane] < 1;
            const Rgba& found = is_white || passes(lane) ? lit : dark;
            for (std::size_t c = 0; c < 4; ++c) out.channel[c][lane] = is_white ? one : found[c];
        }
    }

private:
    /// The coordinates s, t, r.
    HWY_INLINE void divide(const TexturePlanes& p) {
        const D64 d;
        const I32ForD64 i32;
        const std::int32_t* const numerators[] = {values_.s, values_.t, values_.r};
        const int exponents[] = {p.s.exponent, p.t.exponent, p.r.exponent};
        for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
            const auto q = hn::PromoteTo(d, hn::Load(i32, values_.q + i));
            for (std::size_t c = 0; c < 3; ++c) {
                const auto u = hn::PromoteTo(d, hn::Load(i32, numerators[c] + i));
                hn::Store(hn::Mul(hn::Div(u, q), hn::Set(d, power_of_two(exponents[c]))), d,
                          at_[c] + i);
            }
        }
    }
    /// any_position() of gw/stages/perspective.h.
    HWY_INLINE static int position(double at, int size, Wrap wrap) {
        constexpr double most = 1099511627776.0;  // 2^40
        constexpr std::int64_t limit = std::int64_t{1} << 30;
        const std::int64_t texels = 256 * std::int64_t{size};
        const double floor = std::floor(at * double(texels));
        if (!(std::abs(floor) < most)) return any_position(at, 0, 0, size, wrap);
        const auto n = static_cast<std::int64_t>(floor);
        if (wrap != Wrap::Repeat && wrap != Wrap::MirroredRepeat)
            return static_cast<int>(std::clamp(n, -limit, limit));
        const std::int64_t period = wrap == Wrap::Repeat ? texels : 2 * texels;
        if ((period & (period - 1)) == 0) return static_cast<int>(n & (period - 1));
        return static_cast<int>((n % period + period) % period);
    }
    /// The texels of one layer, or the border.
    HWY_INLINE void fetch(std::size_t lane, bool linear, int layer, CornerLanes& out) const {
        if (layer < 0 || layer >= level_.layers) return out.put_one(lane, folded_.border);
        const int u = position(at_[0][lane], level_.width, how_.wrap_s),
                  v = position(at_[1][lane], level_.height, how_.wrap_t);
        folded_.put(lane, level_, linear, u, v, layer, out);
    }
    HWY_INLINE void fetch_layers(std::size_t lane, bool linear) {
        const int w = position(at_[2][lane], level_.layers, how_.wrap_r);
        if (!linear)
            return fetch(lane, linear, wrap_index(how_.wrap_r, w >> 8, level_.layers),
                         found_.first);
        const int from = clamped_position(how_.wrap_r, w, level_.layers) - 128;
        fetch(lane, linear, filter_index(how_.wrap_r, from >> 8, level_.layers), found_.first);
        if ((from & 255) == 0) return;
        if (found_.mixed == 0) found_.second.clear();
        found_.mixed |= 1u << lane;
        found_.weight[lane] = std::uint32_t(from & 255);
        fetch(lane, linear, filter_index(how_.wrap_r, (from >> 8) + 1, level_.layers),
              found_.second);
    }
    HWY_INLINE bool passes(std::size_t lane) const {
        const int bits = texels_.depth_bits;
        const std::uint32_t stored =
            nearest_depth(level_, how_, position(at_[0][lane], level_.width, how_.wrap_s) >> 8,
                          position(at_[1][lane], level_.height, how_.wrap_t) >> 8, bits,
                          double(state_.border_color.x),
                          [&](int i, int j) { return texels_.depths[level_.index(i, j)]; });
        const auto incoming = static_cast<std::uint32_t>(
            to_integer(std::floor(at_[2][lane] * power_of_two(bits)), 0, max_of_bits(bits)));
        return compare(state_.compare_func, incoming, stored);
    }

    const TexelValues& values_;
    const TextureState& state_;
    const Texels& texels_;
    const Addressing how_;
    const FoldedTexels folded_;
    const TexelLevel& level_;
    alignas(64) double at_[3][block_pixels];
    FetchedTexels found_;
};

/// Looks up the lanes of `mask`. Others of `out` stay.
HWY_NOINLINE inline void look_up_with_r(const TexturePlanes& p, const TexelValues& values,
                                        const TileDraw& draw, std::size_t number,
                                        const UnitOp& unit, std::uint32_t mask, ColorBlock& out) {
    const Resolved& r = draw.op->state;
    const TextureState& state = texture_of(r.state, number);
    WithRBlock block(p, values, state, r.texture(number), unit.texels->texels);
    if (state.shadow_compare)
        block.compare_lanes_of(mask, out);
    else
        block.look_up(mask, out);
}

#else

HWY_INLINE bool looks_up_with_r(const TextureState&, const Texels&, const TexturePlanes&) {
    return false;
}
HWY_INLINE void look_up_with_r(const TexturePlanes&, const TexelValues&, const TileDraw&,
                               std::size_t, const UnitOp&, std::uint32_t, ColorBlock&) {}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
