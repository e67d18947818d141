// Look-ups of a block in textures of 8 bits whose sides are no powers of two. docs/manual/texture.md;
// scalar twin: gw/fast/shade/texture_by_pixel.cpp. Included once per Highway target.
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
    return texels.any_size && !texels.with_r && !s.shadow_compare && !unit.projective &&
           !texels.packed.empty() && s.wrap_s != Wrap::MirroredRepeat &&
           s.wrap_t != Wrap::MirroredRepeat && fits(p.s) && fits(p.t);
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
          how_(addressing(state, texels, resolved.border_color)) {}

    /// Precondition of the values: denominators at least 1 in the lanes of `mask`.
    HWY_INLINE void look_up(const TexelValues& values, const Tile& tile, int bx, int by,
                            std::uint32_t mask, ColorBlock& out) {
        const bool by_rho = needs_rho(state_);
        divide(values);
        if (by_rho) find_rho(tile, bx, by);
        const auto fetch_one = [&](std::size_t lane, int level, bool linear, CornerLanes& corners) {
            fetch(lane, texels_.levels[std::size_t(level)], linear, corners);
        };
        found_.fetch(state_, int(texels_.levels.size()), by_rho ? rho_ : nullptr, mask, fetch_one);
        found_.filter(mask, out);
    }

private:
    HWY_INLINE void divide(const TexelValues& values) {
        const F32 f;
        const I32 d;
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            const auto w = hn::Div(hn::Set(f, 1.0f), hn::ConvertTo(f, hn::Load(d, values.q + i)));
            const auto over = [&](const std::int32_t* u, const TexturePlane& of) {
                const auto scale = static_cast<float>(power_of_two(of.exponent));
                return hn::Mul(hn::Mul(hn::ConvertTo(f, hn::Load(d, u + i)), w), hn::Set(f, scale));
            };
            hn::Store(w, f, w_ + i);
            hn::Store(over(values.s, p_.s), f, s_ + i);
            hn::Store(over(values.t, p_.t), f, t_ + i);
        }
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
    /// any_position() of gw/stages/perspective.h of a quotient that is scaled by 2^exponent.
    HWY_INLINE static int position(float scaled, std::int32_t k, int size, Wrap wrap) {
        constexpr std::int64_t limit = std::int64_t{1} << 30;
        const std::int64_t texels = 256 * std::int64_t{size};
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
        if (!linear) return out.put_one(lane, packed(lookup(texels_, level, false, how_, u, v)));
        const int us = clamped_position(how_.wrap_s, u, level.width) - 128,
                  vs = clamped_position(how_.wrap_t, v, level.height) - 128;
        const int i = us >> 8, j = vs >> 8;
        const bool is_inside = i >= 0 && j >= 0 && i < level.width - 1 && j < level.height - 1;
        if (!is_inside) return fetch_at_side(lane, level, us, vs, out);
        const std::uint32_t *const low = texels_.packed.data() + level.index(i, j), *const high =
                                                                                        low +
                                                                                        level.width;
        out.put(lane, low[0], low[1], high[0], high[1], us & 255, vs & 255);
    }
    HWY_NOINLINE void fetch_at_side(std::size_t lane, const TexelLevel& level, int us, int vs,
                                    CornerLanes& out) const {
        const int i = us >> 8, j = vs >> 8;
        const auto at = [&](int x, int y) {
            return packed(filter_texel(texels_, level, how_, x, y));
        };
        out.put(lane, at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), us & 255, vs & 255);
    }

    const TexturePlanes& p_;
    const TextureState& state_;
    const Texels& texels_;
    const ResolvedTexture& resolved_;
    const Addressing how_;
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
