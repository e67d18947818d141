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
#include "gw/fast/shade/fetched-inl.h"
#include "gw/stages/perspective.h"

#include <algorithm>
#include <cmath>

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
          how_(addressing(state, texels, resolved.border_color)),
          folded_{texels, how_} {}

    /// Precondition of the values: denominators at least 1 in the lanes of `mask`, unless they are
    /// projective. There the texel is white.
    HWY_INLINE void look_up(const TexelValues& values, const Tile& tile, int bx, int by,
                            std::uint32_t mask, ColorBlock& out) {
        const bool by_rho = needs_rho(state_);
        const std::uint32_t outside = divide(values) & mask;
        if (by_rho) find_rho(tile, bx, by);
        const auto fetch_one = [&](std::size_t lane, int level, bool linear, CornerLanes& corners) {
            fetch(lane, texels_.levels[std::size_t(level)], linear, corners);
        };
        found_.fetch(state_, int(texels_.levels.size()), by_rho ? rho_ : nullptr, mask & ~outside,
                     fetch_one);
        for (std::uint32_t rest = outside; rest != 0; rest &= rest - 1)
            found_.put_white(std::size_t(std::countr_zero(rest)));
        found_.filter(mask, out);
    }

private:
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
    HWY_INLINE int mirrored(float scaled, std::int32_t k, int size) const {
        constexpr double most = 1099511627776.0;  // 2^40
        const std::int64_t texels = 256 * std::int64_t{size};
        const double n = std::floor(double(scaled) * double(texels));
        if (texels_.any_size || !(std::abs(n) < most))
            return any_position(double(scaled), 0, k, size, Wrap::MirroredRepeat);
        return static_cast<int>((static_cast<std::int64_t>(n) + k * texels) & (2 * texels - 1));
    }
    /// PixelSampler::position() of gw/fast/shade/texture_by_pixel.cpp of a quotient that is scaled by
    /// 2^exponent, modulo the size under Repeat.
    HWY_INLINE int position(float scaled, std::int32_t k, int size, Wrap wrap) const {
        constexpr std::int64_t limit = std::int64_t{1} << 30;
        const std::int64_t texels = 256 * std::int64_t{size};
        if (wrap == Wrap::MirroredRepeat) return mirrored(scaled, k, size);
        if (!texels_.any_size) {
            const double u = double(scaled) * double(texels);
            const auto n =
                static_cast<std::int64_t>(std::floor(std::clamp(u, -double(limit), double(limit))));
            return static_cast<int>(wrap == Wrap::Repeat ? n & (texels - 1) : n + k * texels);
        }
        const auto n = static_cast<std::int64_t>(std::floor(double(scaled) * double(texels)));
        if (wrap != Wrap::Repeat)
            return static_cast<int>(std::clamp(n + k * texels, -limit, limit));
        if (n == static_cast<std::uint32_t>(n))  // a division of 32 bits is quicker
            return static_cast<int>(static_cast<std::uint32_t>(n) %
                                    static_cast<std::uint32_t>(texels));
        return static_cast<int>((n % texels + texels) % texels);
    }
    HWY_INLINE void fetch(std::size_t lane, const TexelLevel& level, bool linear,
                          CornerLanes& out) const {
        const int u = position(s_[lane], p_.s.k, level.width, how_.wrap_s),
                  v = position(t_[lane], p_.t.k, level.height, how_.wrap_t);
        if (!linear) return out.put_one(lane, folded_.nearest(level, u, v, 0));
        const int us = clamped_position(how_.wrap_s, u, level.width) - 128,
                  vs = clamped_position(how_.wrap_t, v, level.height) - 128;
        const int i = us >> 8, j = vs >> 8;
        if (i < 0 || j < 0 || i >= level.width - 1 || j >= level.height - 1)
            return fetch_at_side(lane, level, us, vs, out);
        const std::uint32_t *const low = texels_.packed.data() + level.index(i, j), *const high =
                                                                                        low +
                                                                                        level.width;
        out.put(lane, low[0], low[1], high[0], high[1], us & 255, vs & 255);
    }
    HWY_NOINLINE void fetch_at_side(std::size_t lane, const TexelLevel& level, int us, int vs,
                                    CornerLanes& out) const {
        folded_.put_corners(lane, level, us, vs, 0, out);
    }

    const TexturePlanes& p_;
    const TextureState& state_;
    const Texels& texels_;
    const ResolvedTexture& resolved_;
    const Addressing how_;
    const FoldedTexels folded_;
    alignas(64) float w_[block_pixels], s_[block_pixels], t_[block_pixels], rho_[block_pixels];
    FetchedTexels found_;
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
