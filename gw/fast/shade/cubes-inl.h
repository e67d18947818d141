// Look-ups of a block in cube maps of 8 bits: faces and levels of detail in vectors, texels lane by
// lane, filters in vectors. docs/manual/texture.md, "Textures with r"; scalar twin:
// gw/stages/textures/layers.cpp. Included once per Highway target.
#if defined(GW_FAST_CUBES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_CUBES_INL_H_
#undef GW_FAST_CUBES_INL_H_
#else
#define GW_FAST_CUBES_INL_H_
#endif

#include "gw/fast/shade/fetched-inl.h"
#include "gw/stages/textures/layers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

HWY_INLINE bool looks_up_cube(const TextureState& s, const Texels& texels, const TexturePlanes& p) {
    const auto fits = [](const TexturePlane& t) { return std::abs(t.exponent) <= 100; };
    return texels.cube && !s.shadow_compare && !texels.packed.empty() && fits(p.s) && fits(p.t) &&
           fits(p.r);
}

/// A block of one primitive on a cube.
class CubeBlock {
public:
    HWY_INLINE CubeBlock(const TexturePlanes& p, const TexelValues& values, const TileDraw& draw,
                         const TextureState& state, const ResolvedTexture& resolved,
                         const Texels& texels, int bx, int by)
        : p_(p),
          values_(values),
          state_(state),
          resolved_(resolved),
          texels_(texels),
          dx_(draw.tile.x + bx * block_side - p.slope_x),
          dy_(draw.tile.y + by * block_side - p.slope_y) {}

    HWY_INLINE void look_up(std::uint32_t mask, ColorBlock& out) {
        find_directions();
        std::uint32_t of_face[6] = {};
        for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
            const auto lane = std::size_t(std::countr_zero(rest));
            if (values_.q[lane] < 1)
                found_.put_white(lane);
            else
                of_face[face_of(d_[0][lane], d_[1][lane], d_[2][lane])] |= 1u << lane;
        }
        for (int face = 0; face < 6; ++face)
            if (of_face[face] != 0) fetch_face(face, of_face[face]);
        found_.filter(mask, out);
    }

private:
    HWY_INLINE const TexturePlane& coordinate(int c) const {
        return c == 0 ? p_.s : c == 1 ? p_.t : p_.r;
    }
    HWY_INLINE const std::int32_t* numerators(int c) const {
        return c == 0 ? values_.s : c == 1 ? values_.t : values_.r;
    }
    HWY_INLINE void find_directions() {
        const D64 d;
        const I32ForD64 i32;
        for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
            const auto q = hn::PromoteTo(d, hn::Load(i32, values_.q + i));
            for (int c = 0; c < 3; ++c) {
                const auto u = hn::PromoteTo(d, hn::Load(i32, numerators(c) + i));
                hn::Store(hn::Mul(hn::Div(u, q), hn::Set(d, power_of_two(coordinate(c).exponent))),
                          d, d_[c] + i);
            }
        }
    }
    /// face_point() of gw/stages/textures/layers.h.
    HWY_INLINE void find_points(const FaceRule& rule) {
        const D64 d;
        const auto half = all(0.5), one = all(1);
        for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
            const auto major = hn::Abs(hn::Load(d, d_[rule.major] + i));
            const auto has_direction = hn::Gt(major, hn::Zero(d));
            const auto put = [&](int c, bool is_negative, double* to) {
                const auto own = hn::Load(d, d_[c] + i);
                const auto over = hn::Div(is_negative ? hn::Neg(own) : own, major);
                hn::Store(hn::IfThenElse(has_direction, hn::Mul(hn::Add(over, one), half), half), d,
                          to + i);
            };
            put(rule.s, rule.s_is_negative, s_);
            put(rule.t, rule.t_is_negative, t_);
        }
    }
    HWY_INLINE void find_rho(const FaceRule& rule) {
        const F32 f;
        const I32 d;
        const TexturePlane& major = coordinate(rule.major);
        const int width = texels_.levels[std::size_t(base())].width;
        const auto slope = [&](int c) {
            return coordinate_slope(coordinate(c).plane_slope, major.plane_slope);
        };
        const auto scale = [&](int c) {
            return power_of_two(coordinate(c).exponent - major.exponent - 1) * width;
        };
        BlockSlopes slopes;
        alignas(64) float spread[block_pixels];
        find_slopes(slope(rule.s), slope(rule.t), dx_, dy_, scale(rule.s), scale(rule.t),
                    state_.exact_rho, slopes);
        spread_slopes(slopes, spread);
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            const auto q = hn::Abs(hn::Load(d, numerators(rule.major) + i));
            const auto w = hn::Div(hn::Set(f, 1.0f), hn::ConvertTo(f, q));
            const auto rho = limited_rho(rho_lanes(hn::Load(f, spread + i), w), resolved_);
            const auto is_zero = hn::RebindMask(f, hn::Eq(q, hn::Zero(d)));
            hn::Store(hn::IfThenZeroElse(is_zero, rho), f, rho_ + i);
        }
    }
    HWY_INLINE int base() const { return level_range(state_, int(texels_.levels.size())).base; }

    /// The texels of the lanes of one face.
    HWY_NOINLINE void fetch_face(int face, std::uint32_t lanes) {
        const FaceRule& rule = face_rules[std::size_t(face)];
        const bool by_rho = needs_rho(state_);
        find_points(rule);
        if (by_rho) find_rho(rule);
        const auto fetch_one = [&](std::size_t lane, int level, bool linear, CornerLanes& out) {
            fetch(lane, face, level, linear, out);
        };
        found_.fetch(state_, int(texels_.levels.size()), by_rho ? rho_ : nullptr, lanes, fetch_one);
    }
    HWY_INLINE void fetch(std::size_t lane, int face, int index, bool linear,
                          CornerLanes& out) const {
        const TexelLevel& level = texels_.levels[std::size_t(index)];
        const int n = level.width;
        const auto position = [&](double v) { return int(std::floor(v * (256.0 * n))); };
        const int u = position(s_[lane]), v = position(t_[lane]);
        const std::uint32_t* const texels = texels_.packed.data() + level.index(0, 0, face);
        if (!linear) {
            const int i = std::min(u >> 8, n - 1), j = std::min(v >> 8, n - 1);
            return out.put_one(lane, texels[pixel_index(i, j, n)]);
        }
        const int us = u - 128, vs = v - 128, i = us >> 8, j = vs >> 8;
        const bool is_inside = i >= 0 && j >= 0 && i < n - 1 && j < n - 1;
        if (!is_inside) return fetch_at_edge(lane, face, level, us, vs, out);
        const std::uint32_t *const low = texels + pixel_index(i, j, n), *const high = low + n;
        out.put(lane, low[0], low[1], high[0], high[1], us & 255, vs & 255);
    }
    HWY_NOINLINE void fetch_at_edge(std::size_t lane, int face, const TexelLevel& level, int us,
                                    int vs, CornerLanes& out) const {
        const int i = us >> 8, j = vs >> 8;
        const auto at = [&](int x, int y) {
            return packed(face_texel(texels_, level, state_.seamless, face, x, y));
        };
        out.put(lane, at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), us & 255, vs & 255);
    }

    const TexturePlanes& p_;
    const TexelValues& values_;
    const TextureState& state_;
    const ResolvedTexture& resolved_;
    const Texels& texels_;
    const int dx_, dy_;
    alignas(64) double d_[3][block_pixels], s_[block_pixels], t_[block_pixels];
    alignas(64) float rho_[block_pixels];
    FetchedTexels found_;
};

/// Looks up the lanes of `mask`. Others of `out` stay.
HWY_NOINLINE inline void look_up_cube(const TexturePlanes& p, const TexelValues& values,
                                      const TileDraw& draw, std::size_t number, const UnitOp& unit,
                                      int bx, int by, std::uint32_t mask, ColorBlock& out) {
    const Resolved& r = draw.op->state;
    CubeBlock block(p, values, draw, texture_of(r.state, number), r.texture(number),
                    unit.texels->texels, bx, by);
    block.look_up(mask, out);
}

#else

HWY_INLINE bool looks_up_cube(const TextureState&, const Texels&, const TexturePlanes&) {
    return false;
}
HWY_INLINE void look_up_cube(const TexturePlanes&, const TexelValues&, const TileDraw&, std::size_t,
                             const UnitOp&, int, int, std::uint32_t, ColorBlock&) {}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
