// Look-ups of a block in textures of 8 bits that have two dimensions, of any size and wrap, with
// coordinates that are projective or not. docs/manual/texture.md; scalar twin:
// gw/fast/shade/texture_by_pixel.cpp. Included once per Highway target.
#if defined(GW_FAST_SIZED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SIZED_INL_H_
#undef GW_FAST_SIZED_INL_H_
#else
#define GW_FAST_SIZED_INL_H_
#endif

#include "gw/fast/plan/draw_op.h"
#include "gw/fast/shade/sized_sampler-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE bool looks_up_sized(const TextureState& s, const UnitOp& unit, const TexturePlanes& p) {
    const Texels& texels = unit.texels->texels;
    const auto fits = [](const TexturePlane& t) { return t.exponent <= largest_exponent_in_float; };
    return !texels.with_r && !texels.cube && !s.shadow_compare && !texels.packed.empty() &&
           fits(p.s) && fits(p.t);
}

/// A block of one primitive.
class SizedBlock {
public:
    HWY_INLINE SizedBlock(const TexturePlanes& p, const TextureState& state,
                          const ResolvedTexture& resolved, const Texels& texels)
        : p_(p),
          state_(state),
          texels_(texels),
          resolved_(resolved),
          folded_{texels, addressing(state, texels, resolved.border_color)} {}

    /// Where denominators are below 1, the texel is white.
    HWY_INLINE void look_up(const TexelValues& values, const Tile& tile, int bx, int by,
                            std::uint32_t mask, ColorBlock& out) {
        const std::uint32_t outside = divide(values) & mask;
        if (needs_rho(state_)) find_rho(tile, bx, by);
        if (std::popcount(mask) <= few_lanes)
            look_up_few(mask & ~outside, out);
        else
            look_up_lanes(mask & ~outside, out);
        for (std::uint32_t rest = outside; rest != 0; rest &= rest - 1)
            for (auto& channel : out.channel) channel[std::countr_zero(rest)] = 255;
    }

private:
    /// Up to which vectors do not pay.
    static constexpr int few_lanes = 3;

    HWY_NOINLINE void look_up_lanes(std::uint32_t mask, ColorBlock& out) const {
        const I32 d;
        const F32 f;
        ColorBlock found;
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            if (!has_part(mask, i / lanes32)) continue;
            const Coordinates at{hn::Load(f, s_ + i), hn::Load(f, t_ + i), hn::Set(d, p_.s.k),
                                 hn::Set(d, p_.t.k)};
            const TexelLanes texel = sample<TexelWords>(sampler_, at, rho_ + i).channels();
            for (std::size_t k = 0; k < 4; ++k) store16(texel.channel[k], found.channel[k] + i);
        }
        copy_lanes(found, mask, out);
    }
    HWY_NOINLINE void look_up_few(std::uint32_t mask, ColorBlock& out) const {
        FetchedTexels found;
        const auto fetch_one = [&](std::size_t lane, int index, bool linear, CornerLanes& corners) {
            const TexelLevel& level = texels_.levels[std::size_t(index)];
            const int u = sampler_.position(s_[lane], p_.s.k, level.width, folded_.how.wrap_s),
                      v = sampler_.position(t_[lane], p_.t.k, level.height, folded_.how.wrap_t);
            folded_.put(lane, level, linear, u, v, 0, corners);
        };
        found.fetch(state_, int(texels_.levels.size()), needs_rho(state_) ? rho_ : nullptr, mask,
                    fetch_one);
        found.filter(mask, out);
    }
    /// Returns the lanes with denominators below 1.
    HWY_INLINE std::uint32_t divide(const TexelValues& values) {
        const F32 f;
        const I32 d;
        std::uint32_t outside = 0;
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            const auto q = hn::Load(d, values.q + i), one = hn::Set(d, 1);
            outside |= bits_of(d, hn::Lt(q, one), lanes32) << i;
            const auto w = hn::Div(hn::Set(f, 1.0f), hn::ConvertTo(f, hn::Max(q, one)));
            const auto over = [&](const std::int32_t* u, const TexturePlane& of) {
                const auto scale = static_cast<float>(power_of_two(of.exponent));
                return hn::Mul(hn::Mul(hn::ConvertTo(f, hn::Load(d, u + i)), w), hn::Set(f, scale));
            };
            hn::Store(w, f, w_ + i);
            hn::Store(over(values.s, p_.s), f, s_ + i);
            hn::Store(over(values.t, p_.t), f, t_ + i);
        }
        return outside;
    }
    HWY_INLINE void find_rho(const Tile& tile, int bx, int by) {
        const F32 f;
        const int base = level_range(state_, int(texels_.levels.size())).base;
        const TexelLevel& level = texels_.levels[std::size_t(base)];
        BlockSlopes slopes;
        alignas(64) float spread[block_pixels];
        find_slopes(p_.s.slope, p_.t.slope, tile.x + bx * block_side - p_.slope_x,
                    tile.y + by * block_side - p_.slope_y,
                    power_of_two(p_.s.exponent) * level.width,
                    power_of_two(p_.t.exponent) * level.height, state_.exact_rho, slopes);
        spread_slopes(slopes, spread);
        for (std::size_t i = 0; i < block_pixels; i += lanes32)
            hn::Store(
                limited_rho(rho_lanes(hn::Load(f, spread + i), hn::Load(f, w_ + i)), resolved_), f,
                rho_ + i);
    }
    const TexturePlanes& p_;
    const TextureState& state_;
    const Texels& texels_;
    const ResolvedTexture& resolved_;
    const FoldedTexels folded_;
    const SizedSampler sampler_{folded_, state_};
    alignas(64) float w_[block_pixels], s_[block_pixels], t_[block_pixels], rho_[block_pixels];
};

/// Looks up the lanes of `mask`. Others of `out` stay.
HWY_NOINLINE inline void look_up_sized(const TexturePlanes& p, const TexelValues& values,
                                       const TileDraw& draw, std::size_t number, const UnitOp& unit,
                                       int bx, int by, std::uint32_t mask, ColorBlock& out) {
    const Resolved& r = draw.op->state;
    SizedBlock block(p, texture_of(r.state, number), r.texture(number), unit.texels->texels);
    block.look_up(values, draw.tile, bx, by, mask, out);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
