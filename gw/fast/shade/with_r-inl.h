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
#include "gw/fast/shade/positions-inl.h"
#include "gw/stages/tables.h"

#include <bit>
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
        const std::uint32_t white = outside() & mask, found = mask & ~white;
        find_position(found, 0, level_.width, how_.wrap_s);
        find_position(found, 1, level_.height, how_.wrap_t);
        if (texels_.dimensions == 3) {
            find_position(found, 2, level_.layers, how_.wrap_r);
            look_up_layers(found, out);
        } else {
            look_up_one_layer(found, out);
        }
        for (std::uint32_t rest = white; rest != 0; rest &= rest - 1)
            for (auto& channel : out.channel) channel[std::countr_zero(rest)] = 255;
    }
    /// r against the depth of the nearest texel.
    HWY_INLINE void compare_lanes_of(std::uint32_t mask, ColorBlock& out) {
        find_position(mask, 0, level_.width, how_.wrap_s);
        find_position(mask, 1, level_.height, how_.wrap_t);
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
    /// Lanes with denominators below 1.
    HWY_INLINE std::uint32_t outside() const {
        const I32 d;
        std::uint32_t found = 0;
        for (std::size_t i = 0; i < block_pixels; i += lanes32)
            found |= bits_of(d, hn::Lt(hn::Load(d, values_.q + i), hn::Set(d, 1)), lanes32) << i;
        return found;
    }
    /// any_position() of the lanes of `mask`; under a repetition 0 may be the period.
    HWY_INLINE void find_position(std::uint32_t mask, std::size_t c, int size, Wrap wrap) {
        const D64 d;
        const I32ForD64 i32;
        const auto texels = hn::Set(d, 256.0 * size);
        std::uint32_t usual = 0;
        for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
            const auto n = hn::Floor(hn::Mul(hn::Load(d, at_[c] + i), texels));
            const auto is_usual = hn::Lt(hn::Abs(n), hn::Set(d, 0x1p40));
            usual |= bits_of(d, is_usual, hn::Lanes(d)) << i;
            const auto folded = folded_position(hn::IfThenElseZero(is_usual, n), texels, wrap);
            hn::Store(hn::DemoteTo(i32, folded), i32, position_[c] + i);
        }
        for (std::uint32_t rest = mask & ~usual; rest != 0; rest &= rest - 1) {
            const auto lane = std::size_t(std::countr_zero(rest));
            position_[c][lane] = any_position(at_[c][lane], 0, 0, size, wrap);
        }
    }

    HWY_NOINLINE void look_up_one_layer(std::uint32_t mask, ColorBlock& out) const {
        FetchedTexels found;
        for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
            const auto lane = std::size_t(std::countr_zero(rest));
            folded_.put(lane, level_, is_linear(state_, true), position_[0][lane],
                        position_[1][lane], 0, found.first);
        }
        found.filter(mask, out);
    }
    HWY_NOINLINE void look_up_layers(std::uint32_t mask, ColorBlock& out) const {
        const I32 d;
        const bool linear = is_linear(state_, true);
        ColorBlock found;
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            if (!has_part(mask, i / lanes32)) continue;
            const VI u = hn::Load(d, position_[0] + i), v = hn::Load(d, position_[1] + i),
                     w = hn::Load(d, position_[2] + i);
            const TexelLanes texel = (linear ? eight(u, v, w) : one(u, v, w)).channels();
            for (std::size_t k = 0; k < 4; ++k) store16(texel.channel[k], found.channel[k] + i);
        }
        copy_lanes(found, mask, out);
    }
    HWY_INLINE TexelWords one(VI u, VI v, VI w) const {
        const auto index = [](Wrap wrap, VI position, VI size) {
            return nearest_index(wrap, hn::ShiftRight<8>(position), size);
        };
        return words_of(texel(index(how_.wrap_s, u, width_), index(how_.wrap_t, v, height_),
                              index(how_.wrap_r, w, layers_)));
    }
    /// The mean of four texels in each of two layers.
    HWY_INLINE TexelWords eight(VI u, VI v, VI w) const {
        const Neighbours column(how_.wrap_s, u, width_), row(how_.wrap_t, v, height_),
            layer(how_.wrap_r, w, layers_);
        const auto four = [&](VI k) {
            return bilinear_bytes(
                {texel(column.first, row.first, k), texel(column.second, row.first, k),
                 texel(column.first, row.second, k), texel(column.second, row.second, k)},
                column.weight, row.weight);
        };
        return between_levels(four(layer.first), four(layer.second), layer.weight);
    }
    /// Two indices of a linear filter, and the weight of the second in 256ths.
    struct Neighbours {
        VI first, second;
        V32 weight;

        HWY_INLINE Neighbours(Wrap wrap, VI position, VI size) {
            const I32 d;
            const VI from = from_first_centre(wrap, position, size),
                     index = hn::ShiftRight<8>(from);
            first = linear_index(wrap, index, size);
            second = linear_index(wrap, hn::Add(index, hn::Set(d, 1)), size);
            weight = hn::BitCast(D32(), hn::And(from, hn::Set(d, 255)));
        }
    };
    /// The texels of a volume, or its border.
    HWY_INLINE V32 texel(VI i, VI j, VI k) const {
        const I32 d;
        const auto inside = [&](VI index, VI size) {
            return within(index, hn::Zero(d), hn::Sub(size, hn::Set(d, 1)));
        };
        const auto fetch = [&](VI x, VI y, VI z) {
            const VI row = hn::Add(hn::Mul(z, height_), y);
            return hn::GatherIndex(D32(), texels_.packed.data() + level_.first,
                                   hn::Add(hn::Mul(row, width_), x));
        };
        if (!has_border_) return fetch(i, j, k);
        const VI x = inside(i, width_), y = inside(j, height_), z = inside(k, layers_);
        const auto is_inside = hn::And(hn::And(hn::Eq(x, i), hn::Eq(y, j)), hn::Eq(z, k));
        return hn::IfThenElse(hn::RebindMask(D32(), is_inside), fetch(x, y, z),
                              hn::Set(D32(), folded_.border));
    }
    HWY_INLINE bool passes(std::size_t lane) const {
        const int bits = texels_.depth_bits;
        const std::uint32_t stored =
            nearest_depth(level_, how_, position_[0][lane] >> 8, position_[1][lane] >> 8, bits,
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
    const VI width_ = hn::Set(I32(), level_.width), height_ = hn::Set(I32(), level_.height),
             layers_ = hn::Set(I32(), level_.layers);
    const bool has_border_ = reaches_outside(how_.wrap_s) || reaches_outside(how_.wrap_t) ||
                             reaches_outside(how_.wrap_r);
    alignas(64) double at_[3][block_pixels];
    alignas(64) std::int32_t position_[3][block_pixels];
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
