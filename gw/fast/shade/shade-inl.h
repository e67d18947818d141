// Shading a block of 16 pixels of one primitive: depth, colour, texture environment, fog.
// docs/manual.md, "Planes" to "Fog"; scalar twins: gw/reference/interpolants.cpp, shade.cpp. Does
// not decide coverage or test. Included once per Highway target.
#if defined(GW_FAST_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SHADE_INL_H_
#undef GW_FAST_SHADE_INL_H_
#else
#define GW_FAST_SHADE_INL_H_
#endif

#include "gw/fast/shade/colors-inl.h"
#include "gw/fast/shade/combine-inl.h"
#include "gw/fast/shade/coordinates-inl.h"
#include "gw/fast/shade/look_up-inl.h"
#include "gw/fast/shade/wide_colors-inl.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/stages/fog.h"
#include "gw/stages/tables.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE void shade_depth(const DepthPlane& p, std::uint32_t max_depth, int bx, int by,
                            DepthBlock& out) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        hn::Store(wide_plane(p.plane, pixels_of(bx, by, i)), d, out.value + i);
    if (p.offset != 0) offset_depths(p.offset, max_depth, out);
}

/// The inputs of shading for 16 pixels, which may belong to different primitives.
struct ShadeInputs {
    ColorBlock color;
    TexelBlocks texels;  ///< by unit; most draws have the first only
    ColorBlock out;      ///< of the texture environment, colour sum and fog
    ColorBlock secondary;
    TextureInputs texture;
    TextureLanes divided;
    alignas(64) std::uint32_t fog[block_pixels];
};

/// Coefficients of narrow planes; each lane may have its own primitive. They are vectors, so that
/// they stay in registers.
template <std::size_t channels>
struct NarrowLanes {
    V32 c[channels][parts], gx[channels][parts], gy[channels][parts];

    HWY_INLINE void clear() {
        for (std::size_t k = 0; k < channels; ++k)
            for (std::size_t i = 0; i < parts; ++i) c[k][i] = gx[k][i] = gy[k][i] = hn::Zero(D32());
    }
    /// Puts triangle j of a batch into these lanes.
    HWY_INLINE void put(const NarrowBatch& p, std::size_t j, const LaneSet& lanes) {
        const D32 d;
        const auto put = [&](V32& v, std::size_t i, std::uint32_t value) {
            v = hn::IfThenElse(lanes.part[i], hn::Set(d, value), v);
        };
        for (std::size_t k = 0; k < channels; ++k)
            for (std::size_t i = 0; i < parts; ++i) {
                put(c[k][i], i, p.c[k][j]);
                put(gx[k][i], i, p.gx[k][j]);
                put(gy[k][i], i, p.gy[k][j]);
            }
    }
    /// Colour, and the fog factor if there are five channels.
    HWY_INLINE void store(int bx, int by, ShadeInputs& in) const {
        for (std::size_t i = 0; i < parts; ++i) {
            const Pixels at = pixels_of(bx, by, i * lanes32);
            const auto value = [&](std::size_t k) {
                return narrow_value(c[k][i], gx[k][i], gy[k][i], at);
            };
            for (std::size_t k = 0; k < 4; ++k)
                store16(value(k), in.color.channel[k] + i * lanes32);
            if constexpr (channels == 5) hn::Store(value(4), D32(), in.fog + i * lanes32);
        }
    }
};

/// Colour, and the fog factor if there are five channels, of triangle j of a batch.
HWY_INLINE void narrow_colors(const NarrowBatch& p, std::size_t j, std::size_t channels, int bx,
                              int by, ShadeInputs& in) {
    const auto channel = [&](std::size_t k, const auto& put) {
        narrow_block(p.c[k][j], p.gx[k][j], p.gy[k][j], bx, by, put);
    };
    for (std::size_t k = 0; k < 4; ++k)
        channel(k, [&](std::size_t part, V32 value) {
            store16(value, in.color.channel[k] + part * lanes32);
        });
    if (channels == 5)
        channel(4, [&](std::size_t part, V32 value) {
            hn::Store(value, D32(), in.fog + part * lanes32);
        });
}

/// Stores the lanes of `mask`.
HWY_INLINE void blend16(V32 v, std::uint32_t mask, std::size_t first, std::uint16_t* p) {
    const Half16 d;
    store_lanes(narrow(v), lanes_of(d, mask, first), d, p + first);
}

HWY_NOINLINE inline void interpolated_color(const ColorPlanes& p, int bits, int bx, int by,
                                            std::uint32_t mask, ColorBlock& out) {
    if (p.perspective) {
        PerspectiveColors colors;
        colors.aim(p, 0);
        return colors.at(p, bits, bx, by, [&](std::size_t c, std::size_t part, V32 value) {
            blend16(value, mask, part * lanes32, out.channel[c]);
        });
    }
    for (std::size_t first = 0; first < block_pixels; first += lanes32)
        for (std::size_t c = 0; c < 4; ++c)
            blend16(narrow_plane(p.color[c], pixels_of(bx, by, first)), mask, first,
                    out.channel[c]);
}

/// The most common operation of multi-pass rendering: modulate in 8 bits.
HWY_INLINE void modulate_bytes(const ColorBlock& color, const ColorBlock& texel, ColorBlock& out) {
    const D16 d;
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < block_pixels; i += lanes16)
            hn::Store(
                mul_bytes(d, hn::Load(d, color.channel[c] + i), hn::Load(d, texel.channel[c] + i)),
                d, out.channel[c] + i);
}

/// Lane by lane, if the lanes cannot be combined together.
HWY_NOINLINE inline void combine_block(const DrawOp& op, const ColorBlock& color,
                                       const ColorBlock& texel, ColorBlock& out) {
    const TextureState& state = op.state.state.texture;
    if (combines_lanes(state, op.state.bits)) {
        const CombineBlocks in{.texel = {&texel},
                               .format = {op.texels->texels.format},
                               .constant = op.state.env_color,
                               .primary = &color,
                               .previous = &color,
                               .bits = op.state.bits};
        return combine_lanes(state, in, out);
    }
    const auto at = [](const ColorBlock& b, std::size_t i) {
        return Rgba{b.channel[0][i], b.channel[1][i], b.channel[2][i], b.channel[3][i]};
    };
    for (std::size_t i = 0; i < block_pixels; ++i) {
        const Rgba combined = texture_environment(state, op.texels->texels.format, at(color, i),
                                                  at(texel, i), op.state.env_color, op.state.bits);
        for (std::size_t c = 0; c < 4; ++c) out.channel[c][i] = combined[c];
    }
}

/// texture_environment() of gw/stages/tables.h, without Combine. `out` may be `color`.
HWY_NOINLINE inline void apply_environment(TexEnv mode, TextureFormat format, const Rgba& env,
                                           int bits, const ColorBlock& color,
                                           const ColorBlock& texel, ColorBlock& out) {
    if (mode == TexEnv::Modulate && bits == 8) return modulate_bytes(color, texel, out);
    const D32 d;
    const auto max = hn::Set(d, max_of_bits(bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto alpha = load_channel(texel.channel[3] + i);
        for (std::size_t c = 0; c < 4; ++c) {
            const auto f = load_channel(color.channel[c] + i),
                       t = load_channel(texel.channel[c] + i);
            auto v = f;
            switch (environment_op(mode, format, c == 3)) {
                case EnvironmentOp::Keep: break;
                case EnvironmentOp::Replace: v = t; break;
                case EnvironmentOp::Modulate: v = mul_lanes(f, t, bits); break;
                case EnvironmentOp::Decal:
                    v = hn::Add(mul_lanes(f, hn::Sub(max, alpha), bits), mul_lanes(t, alpha, bits));
                    break;
                case EnvironmentOp::Blend:
                    v = hn::Add(mul_lanes(f, hn::Sub(max, t), bits),
                                mul_lanes(hn::Set(d, env[c]), t, bits));
                    break;
                case EnvironmentOp::Add: v = hn::Min(max, hn::Add(f, t)); break;
            }
            store16(v, out.channel[c] + i);
        }
    }
}

/// The environment of unit 0.
HWY_INLINE void apply_first(const DrawOp& op, const ColorBlock& color, const ColorBlock& texel,
                            ColorBlock& out) {
    const TexEnv mode = op.state.state.texture.env;
    if (mode == TexEnv::Combine) return combine_block(op, color, texel, out);
    apply_environment(mode, op.texels->texels.format, op.state.env_color, op.state.bits, color,
                      texel, out);
}
/// The environments of all units in turn.
HWY_NOINLINE inline void apply_all(const TileDraw& draw, const ColorBlock& color,
                                   const TexelBlocks& texels, ColorBlock& out) {
    const DrawOp& op = *draw.op;
    const auto mode = [&](std::size_t unit) { return texture_of(op.state.state, unit).env; };
    const auto is_on = [&](std::size_t unit) { return (*op.units)[unit].texels != nullptr; };
    CombineBlocks blocks{.primary = &color, .previous = &color, .bits = op.state.bits};
    for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
        if (!is_on(unit)) continue;
        blocks.texel[unit] = &texels[unit];
        blocks.format[unit] = (*op.units)[unit].texels->texels.format;
        if (mode(unit) == TexEnv::Combine &&
            !combines_lanes(texture_of(op.state.state, unit), op.state.bits))
            return apply_units(draw, color, texels, out);
    }
    const ColorBlock* from = &color;
    for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
        if (!is_on(unit)) continue;
        if (mode(unit) == TexEnv::Combine) {
            blocks.unit = unit;
            blocks.constant = op.state.texture(unit).env_color;
            blocks.previous = from;
            combine_lanes(texture_of(op.state.state, unit), blocks, out);
            from = &out;
            continue;
        }
        apply_environment(mode(unit), (*op.units)[unit].texels->texels.format,
                          op.state.texture(unit).env_color, op.state.bits, *from, texels[unit],
                          out);
        from = &out;
    }
}

HWY_INLINE V32 fog_factor_lanes(const ColorPlanes& p, const DrawOp& op, Pixels at) {
    if (!op.fog_table) return narrow_plane(p.fog, at);
    const D32 d;
    const I32 i;
    const int steps = 1 << fog_table_log2(op.state.bits);
    const auto f = hn::Mul(hn::Mul(to_floats(wide_plane(p.fog, at)), reciprocal_lanes(p.q, at)),
                           hn::Set(F32(), p.fog_scale));
    const auto clamped = hn::Max(hn::Zero(F32()), hn::Min(f, hn::Set(F32(), float(steps * 256))));
    // Lanes outside the primitive have arbitrary values: the index must stay inside the table.
    const auto last = hn::Set(i, steps * 256);
    const auto position = hn::Max(hn::Zero(i), hn::Min(hn::ConvertTo(i, clamped), last));
    const auto entry = hn::ShiftRight<8>(position),
               next = hn::Min(hn::Add(entry, hn::Set(i, 1)), hn::Set(i, steps));
    const auto a = hn::BitCast(i, hn::GatherIndex(d, op.fog_table->data(), entry));
    const auto b = hn::BitCast(i, hn::GatherIndex(d, op.fog_table->data(), next));
    const auto step =
        hn::Add(hn::Mul(hn::Sub(b, a), hn::And(position, hn::Set(i, 255))), hn::Set(i, 128));
    return hn::BitCast(d, hn::Add(a, hn::ShiftRight<8>(step)));
}

HWY_NOINLINE inline void apply_fog_block(const DrawOp& op, const std::uint32_t* factor,
                                         const ColorBlock& color, ColorBlock& out) {
    const D32 d;
    const int bits = op.state.bits;
    const auto max = hn::Set(d, max_of_bits(bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto f = hn::Load(d, factor + i);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto own = mul_lanes(f, load_channel(color.channel[c] + i), bits);
            const auto fog = mul_lanes(hn::Sub(max, f), hn::Set(d, op.state.fog_color[c]), bits);
            store16(hn::Add(own, fog), out.channel[c] + i);
        }
        if (&out != &color)
            hn::Store(hn::Load(Half16(), color.channel[3] + i), Half16(), out.channel[3] + i);
    }
}

/// Puts the fog factors of the lanes of `mask`, which one primitive covers, into the inputs.
HWY_INLINE void wide_fog(const ColorPlanes& p, const DrawOp& op, int bx, int by, std::uint32_t mask,
                         ShadeInputs& in) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        store_lanes(fog_factor_lanes(p, op, pixels_of(bx, by, i)), lanes_of(d, mask, i), d,
                    in.fog + i);
}
/// The same of colour and fog.
HWY_NOINLINE inline void wide_colors(const ColorPlanes& p, const DrawOp& op, int bx, int by,
                                     std::uint32_t mask, ShadeInputs& in) {
    interpolated_color(p, op.state.bits, bx, by, mask, in.color);
    if (has_fog(op.state.state)) wide_fog(p, op, bx, by, mask, in);
}

/// docs/manual/lighting.md, "Colour sum".
HWY_NOINLINE inline void add_secondary(const DrawOp& op, const ColorBlock& secondary,
                                       const ColorBlock& color, ColorBlock& out) {
    const D16 d;
    const auto max = hn::Set(d, static_cast<std::uint16_t>(max_of_bits(op.state.bits)));
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        for (std::size_t c = 0; c < 3; ++c)
            hn::Store(hn::Min(hn::SaturatedAdd(hn::Load(d, color.channel[c] + i),
                                               hn::Load(d, secondary.channel[c] + i)),
                              max),
                      d, out.channel[c] + i);
        hn::Store(hn::Load(d, color.channel[3] + i), d, out.channel[3] + i);
    }
}

/// Colour, texture, colour sum, fog, in that order. `texel`: of the texture unit, if the draw is textured.
HWY_NOINLINE inline const ColorBlock& shaded(const TileDraw& draw, const ColorBlock& texel,
                                             ShadeInputs& in) {
    const DrawOp& op = *draw.op;
    const State& s = op.state.state;
    if (s.color_source == ColorSource::PolygonId) return in.color;
    const ColorBlock* color = &in.color;
    if (op.texels) {
        if (op.units)
            apply_all(draw, *color, in.texels, in.out);
        else
            apply_first(op, *color, texel, in.out);
        color = &in.out;
    }
    if (op.sums_colors) {
        add_secondary(op, in.secondary, *color, in.out);
        color = &in.out;
    }
    if (s.fog.enable) {
        apply_fog_block(op, in.fog, *color, in.out);
        color = &in.out;
    }
    return *color;
}

/// Looks up the lanes of `mask`, which one primitive covers.
HWY_INLINE void look_up(const TexturePlanes& p, const TileDraw& draw, int bx, int by,
                        std::uint32_t mask, ShadeInputs& in) {
    if (textures_by_pixel(*draw.op)) return look_up_by_unit(p, draw, bx, by, mask, in.texels);
    const Sampler sampler = sampler_of(*draw.op);
    divide_block(sampler, p, draw.tile, bx, by, mask, in.divided);
    sample_block(sampler, in.divided, mask, in.texels[0]);
}
/// The same of values of the planes, by unit.
HWY_INLINE void look_up(const TexturePlanes& p, const UnitValues& values, const TileDraw& draw,
                        int bx, int by, std::uint32_t mask, ShadeInputs& in) {
    if (textures_by_pixel(*draw.op))
        return look_up_by_unit(p, values, draw, bx, by, mask, in.texels);
    const Sampler sampler = sampler_of(*draw.op);
    divide_block(sampler, p, values[0], draw.tile, bx, by, mask, in.divided);
    sample_block(sampler, in.divided, mask, in.texels[0]);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
