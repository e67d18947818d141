// Texels of 8 bits that are fetched lane by lane and filtered in vectors. docs/manual/texture.md;
// scalar twin: gw/stages/texels.cpp. Does not find coordinates. Included once per Highway target.
#if defined(GW_FAST_FETCHED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_FETCHED_INL_H_
#undef GW_FAST_FETCHED_INL_H_
#else
#define GW_FAST_FETCHED_INL_H_
#endif

#include "gw/fast/shade/texture-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Copies the lanes of `mask`.
HWY_INLINE void copy_lanes(const ColorBlock& from, std::uint32_t mask, ColorBlock& to) {
    const Half16 d;
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < block_pixels; i += lanes32)
            store_lanes(hn::Load(d, from.channel[c] + i), lanes_of(d, mask, i), d,
                        to.channel[c] + i);
}

/// rho under texture.lod.
HWY_INLINE VF limited_rho(VF found, const ResolvedTexture& resolved) {
    const F32 f;
    const auto scaled = hn::Mul(found, hn::Set(f, resolved.rho_scale));
    return hn::Min(hn::Max(scaled, hn::Set(f, resolved.least_rho)),
                   hn::Set(f, resolved.greatest_rho));
}

/// The four texels of a filter, and the weights of the right and the upper ones in 256ths.
struct CornerLanes {
    alignas(64) std::uint32_t a[block_pixels], b[block_pixels], c[block_pixels], e[block_pixels],
        wx[block_pixels], wy[block_pixels];

    HWY_INLINE void clear() {
        const D32 d;
        for (std::uint32_t* const lanes : {a, b, c, e, wx, wy})
            for (std::size_t i = 0; i < block_pixels; i += lanes32)
                hn::Store(hn::Zero(d), d, lanes + i);
    }
    HWY_INLINE void put(std::size_t lane, std::uint32_t ta, std::uint32_t tb, std::uint32_t tc,
                        std::uint32_t te, int x, int y) {
        a[lane] = ta;
        b[lane] = tb;
        c[lane] = tc;
        e[lane] = te;
        wx[lane] = std::uint32_t(x);
        wy[lane] = std::uint32_t(y);
    }
    HWY_INLINE void put_one(std::size_t lane, std::uint32_t texel) {
        put(lane, texel, texel, texel, texel, 0, 0);
    }
    HWY_INLINE void copy(std::size_t lane, const CornerLanes& from) {
        put(lane, from.a[lane], from.b[lane], from.c[lane], from.e[lane], int(from.wx[lane]),
            int(from.wy[lane]));
    }
    HWY_INLINE TexelWords mean(std::size_t i) const {
        const D32 d;
        return bilinear_bytes(
            {hn::Load(d, a + i), hn::Load(d, b + i), hn::Load(d, c + i), hn::Load(d, e + i)},
            hn::Load(d, wx + i), hn::Load(d, wy + i));
    }
};

/// The texels of a texture by folded indices. Those outside of a level are its border's.
struct FoldedTexels {
    const Texels& texels;
    const Addressing how;
    const std::uint32_t border = packed(how.border_color);

    HWY_INLINE std::uint32_t at(const TexelLevel& level, int i, int j, int layer) const {
        const bool is_inside = i >= 0 && j >= 0 && i < level.width && j < level.height;
        if (is_inside) return texels.packed[level.index(i, j, layer)];
        if (level.bordered.empty()) return border;
        return packed(level.bordered[pixel_index(i + 1, j + 1, level.width + 2)]);
    }
    /// The texel at u, v, or the four around it.
    HWY_INLINE void put(std::size_t lane, const TexelLevel& level, bool linear, int u, int v,
                        int layer, CornerLanes& out) const {
        if (!linear) return out.put_one(lane, nearest(level, u, v, layer));
        const int us = clamped_position(how.wrap_s, u, level.width) - 128,
                  vs = clamped_position(how.wrap_t, v, level.height) - 128;
        const int i = us >> 8, j = vs >> 8;
        if (i < 0 || j < 0 || i >= level.width - 1 || j >= level.height - 1)
            return put_corners_at_side(lane, level, us, vs, layer, out);
        const std::uint32_t* const low = texels.packed.data() + level.index(i, j, layer);
        const std::uint32_t* const high = low + level.width;
        out.put(lane, low[0], low[1], high[0], high[1], us & 255, vs & 255);
    }

private:
    HWY_NOINLINE void put_corners_at_side(std::size_t lane, const TexelLevel& level, int us, int vs,
                                          int layer, CornerLanes& out) const {
        const auto column = [&](int i) { return filter_index(how.wrap_s, i, level.width); };
        const auto row = [&](int j) { return filter_index(how.wrap_t, j, level.height); };
        const int x0 = column(us >> 8), x1 = column((us >> 8) + 1), y0 = row(vs >> 8),
                  y1 = row((vs >> 8) + 1);
        out.put(lane, at(level, x0, y0, layer), at(level, x1, y0, layer), at(level, x0, y1, layer),
                at(level, x1, y1, layer), us & 255, vs & 255);
    }
    HWY_INLINE std::uint32_t nearest(const TexelLevel& level, int u, int v, int layer) const {
        return at(level, wrap_index(how.wrap_s, u >> 8, level.width),
                  wrap_index(how.wrap_t, v >> 8, level.height), layer);
    }
};

/// A block's texels, at one level or two.
struct FetchedTexels {
    CornerLanes first, second;                       ///< `second` if lanes are mixed
    alignas(64) std::uint32_t weight[block_pixels];  ///< of `second`, in 256ths
    std::uint32_t mixed = 0;                         ///< lanes between two levels

    HWY_INLINE FetchedTexels() {
        const D32 d;
        first.clear();
        for (std::size_t i = 0; i < block_pixels; i += lanes32)
            hn::Store(hn::Zero(d), d, weight + i);
    }
    HWY_INLINE void put_white(std::size_t lane) { first.put_one(lane, ~0u); }

    /// Calls fetch(lane, level, is linear, corners) for the levels of each of `lanes`; `rho` is null
    /// if the filters do not depend on it.
    template <class Fetch>
    HWY_INLINE void fetch(const TextureState& state, int level_count, const float* rho,
                          std::uint32_t lanes, const Fetch& fetch) {
        LevelChoice choice{.magnify = true, .level = level_range(state, level_count).base};
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = std::size_t(std::countr_zero(lanes));
            if (rho) choice = choose_level(state, rho[lane], level_count);
            const bool linear = is_linear(state, choice.magnify);
            fetch(lane, choice.level, linear, first);
            weight[lane] = choice.weight;
            if (choice.weight == 0) continue;
            if (mixed == 0) second.clear();
            mixed |= 1u << lane;
            fetch(lane, choice.next, linear, second);
        }
    }
    /// The texels of the lanes of `mask`. Others of `out` stay.
    HWY_INLINE void filter(std::uint32_t mask, ColorBlock& out) {
        const D32 d;
        if (mixed != 0)
            for (std::uint32_t rest = mask & ~mixed; rest != 0; rest &= rest - 1)
                second.copy(std::size_t(std::countr_zero(rest)), first);
        ColorBlock found;
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            if (!has_part(mask, i / lanes32)) continue;
            TexelWords words = first.mean(i);
            if (mixed != 0) words = between_levels(words, second.mean(i), hn::Load(d, weight + i));
            const TexelLanes texel = words.channels();
            for (std::size_t k = 0; k < 4; ++k) store16(texel.channel[k], found.channel[k] + i);
        }
        copy_lanes(found, mask, out);
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
