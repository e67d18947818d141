// The most common textured triangle in 8 bits: one level, a bilinear filter, modulated by the
// colour or in place of it, no fog. Coordinates, texels and products stay in vectors from block to block. Gives the
// same bits as the stages of shade-inl.h. Does not blend. Included once per Highway target.
#if defined(GW_FAST_MODULATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_MODULATE_INL_H_
#undef GW_FAST_MODULATE_INL_H_
#else
#define GW_FAST_MODULATE_INL_H_
#endif

#include "gw/fast/shade/colors-inl.h"
#include "gw/fast/shade/repeated_texels.h"
#include "gw/fast/shade/sampler-inl.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/stages/tables.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// One coordinate of a triangle's texture at any block, in 1/256 texels from the centre of the
/// first texel.
struct TexelPosition {
    WidePlaneLanes plane;
    float scale;  ///< 256 texels 2^exponent
    std::int32_t origin;

    HWY_INLINE void aim(const TexturePlane& p, int log2_size) {
        plane.aim(p.plane);
        scale = static_cast<float>(power_of_two(p.exponent + log2_size + 8));
        origin = std::int32_t(std::uint32_t(p.k) << (log2_size + 8)) - 128;
    }
    HWY_INLINE VI at(int bx, int by, std::size_t part, VF w) const {
        const F32 f;
        const auto u = hn::Mul(to_floats(plane.at(bx, by, part)), hn::Mul(w, hn::Set(f, scale)));
        const auto inside = hn::Max(hn::Zero(f), hn::Min(u, hn::Set(f, 1073741824.0f)));
        return hn::Add(hn::ConvertTo(I32(), inside), hn::Set(I32(), origin));
    }
};

#if HWY_TARGET == HWY_SCALAR

/// A vector of one lane has no halves for two channels.
struct ModulatedTexels {
    HWY_INLINE static bool applies_to(const DrawOp&) { return false; }
    HWY_INLINE void write(const TileDraw&, const NarrowBatch&, const TexturePlanes&, std::size_t,
                          int, int, std::uint32_t, ColorBlock&) {}
};

#else

/// Stores four channels, given in 16-bit halves, in their rows.
HWY_INLINE void store_words(const TexelWords& words, std::size_t part, ColorBlock& out) {
#if HWY_MAX_BYTES >= 64
    const hn::Repartition<std::int16_t, D32> h;
    const hn::Repartition<std::uint64_t, D32> pairs;
    alignas(64) static constexpr std::uint64_t rows[8] = {0, 2, 4, 6, 1, 3, 5, 7};
    const auto order = hn::SetTableIndices(pairs, rows);
    const TexelLanes t = words.channels();
    const auto two = [&](std::size_t c) {
        const auto mixed = hn::ReorderDemote2To(h, hn::BitCast(I32(), t.channel[c]),
                                                hn::BitCast(I32(), t.channel[c + 1]));
        const hn::Repartition<std::uint16_t, D32> d16;
        hn::Store(hn::BitCast(d16, hn::TableLookupLanes(hn::BitCast(pairs, mixed), order)), d16,
                  out.channel[c]);
    };
    static_cast<void>(part);
    two(0);
    two(2);
#else
    const TexelLanes t = words.channels();
    for (std::size_t c = 0; c < 4; ++c) store16(t.channel[c], out.channel[c] + part * lanes32);
#endif
}

/// A triangle's texels times its colours. Set up once for each triangle.
struct ModulatedTexels {
    WidePlaneLanes q;
    TexelPosition s, t;
    TexelWords color[parts];
    float w = 1;
    bool affine = true;
    std::size_t aimed = batch_capacity;  ///< the triangle of the batch that it is set up for
    KeptTexels* kept = nullptr;          ///< texels of this triangle from an earlier draw

    HWY_INLINE static bool applies_to(const DrawOp& op) {
        const State& s = op.state.state;
        return op.pairs && !needs_rho(s.texture) && !textures_by_pixel(op) &&
               (s.texture.env == TexEnv::Modulate || replaces(op)) && is_narrow(op) &&
               !has_fog(s) && !op.sums_colors;
    }
    /// Whether the texels are the colours: replaced, by a format with all channels.
    HWY_INLINE static bool replaces(const DrawOp& op) {
        const TextureFormat format = op.texels->texels.format;
        return op.state.state.texture.env == TexEnv::Replace &&
               environment_op(TexEnv::Replace, format, false) == EnvironmentOp::Replace &&
               environment_op(TexEnv::Replace, format, true) == EnvironmentOp::Replace;
    }
    /// Writes the parts with lanes of `mask`.
    HWY_NOINLINE void write(const TileDraw& draw, const NarrowBatch& colors,
                            const TexturePlanes& planes, std::size_t triangle, int bx, int by,
                            std::uint32_t mask, ColorBlock& out) {
        const DrawOp& op = *draw.op;
        const TexelLevel& level = op.texels->texels.levels[0];
        const bool replacing = replaces(op), flat = is_flat(op) || replacing;
        if (aimed != triangle) {
            kept = draw.repeated->find(texel_key(*op.pairs, planes));
            aim(planes, level);
            if (flat && !replacing) set_colors(colors, triangle, bx, by);
            aimed = triangle;
        }
        if (!flat) set_colors(colors, triangle, bx, by);
        const hn::Repartition<std::uint16_t, D32> d;
        const auto times = [&](V32 a, V32 b) {
            return hn::BitCast(D32(), mul_bytes(d, hn::BitCast(d, a), hn::BitCast(d, b)));
        };
        if (kept) mask = all_lanes;  // kept blocks are whole
        for (std::size_t i = 0; i < parts; ++i) {
            if (!has_part(mask, i)) continue;
            const TexelWords texel =
                kept ? kept_texels(op, level, bx, by, i) : texels(op, level, bx, by, i);
            if (replacing)
                store_words(texel, i, out);
            else
                store_words({times(texel.rb, color[i].rb), times(texel.ga, color[i].ga)}, i, out);
        }
    }

private:
    HWY_INLINE void aim(const TexturePlanes& p, const TexelLevel& level) {
        affine = (p.q.gx | p.q.gy) == 0;
        if (affine)
            w = hn::GetLane(reciprocal_lanes(p.q, pixels_of(0, 0, 0)));
        else
            q.aim(p.q);
        s.aim(p.s, level.log2_width);
        t.aim(p.t, level.log2_height);
    }
    HWY_INLINE void set_colors(const NarrowBatch& p, std::size_t triangle, int bx, int by) {
        const D32 d;
        for (std::size_t i = 0; i < parts; ++i) {
            const Pixels at = pixels_of(bx, by, i * lanes32);
            const auto value = [&](std::size_t k) {
                return narrow_value(hn::Set(d, p.c[k][triangle]), hn::Set(d, p.gx[k][triangle]),
                                    hn::Set(d, p.gy[k][triangle]), at);
            };
            color[i] = {hn::Or(value(0), hn::ShiftLeft<16>(value(2))),
                        hn::Or(value(1), hn::ShiftLeft<16>(value(3)))};
        }
    }
    /// The same as texels(), in the order of the parts.
    HWY_INLINE TexelWords kept_texels(const DrawOp& op, const TexelLevel& level, int bx, int by,
                                      std::size_t part) const {
        const D32 d;
        const std::size_t block = std::size_t(by) * 16 + std::size_t(bx), lane = part * lanes32;
        KeptTexels::Block& at = kept->blocks[block];
        if (kept->known[block]) return {hn::Load(d, at.rb + lane), hn::Load(d, at.ga + lane)};
        const TexelWords found = texels(op, level, bx, by, part);
        hn::Store(found.rb, d, at.rb + lane);
        hn::Store(found.ga, d, at.ga + lane);
        if (part + 1 == parts) kept->known.set(block);
        return found;
    }
    HWY_INLINE TexelWords texels(const DrawOp& op, const TexelLevel& level, int bx, int by,
                                 std::size_t part) const {
        const F32 f;
        const I32 i;
        const TexelPairs& pairs = *op.pairs;
        const auto over =
            affine ? hn::Set(f, w) : hn::Div(hn::Set(f, 1.0f), to_floats(q.at(bx, by, part)));
        const auto u = s.at(bx, by, part, over), v = t.at(bx, by, part, over);
        const Sampler::Place column = Sampler::place(pairs.how.wrap_s, u, hn::Set(i, level.width)),
                             row = Sampler::place(pairs.how.wrap_t, v, hn::Set(i, level.height));
        const auto index =
            Sampler::pair_index(pairs, row.index, column.index, hn::Set(i, level.log2_width));
        return bilinear_bytes(load_corners(pairs.pairs.data(), index), column.weight, row.weight);
    }
};

#endif  // HWY_TARGET == HWY_SCALAR

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
