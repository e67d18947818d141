// Look-ups of a block in each texture unit of a draw, by the way that its texture allows.
// docs/manual/texture.md; scalar twin: gw/fast/shade/texture_by_pixel.cpp. Does not combine texels.
// Included once per Highway target.
#if defined(GW_FAST_LOOK_UP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_LOOK_UP_INL_H_
#undef GW_FAST_LOOK_UP_INL_H_
#else
#define GW_FAST_LOOK_UP_INL_H_
#endif

#include "gw/fast/shade/compared-inl.h"
#include "gw/fast/shade/cubes-inl.h"
#include "gw/fast/shade/sized-inl.h"
#include "gw/fast/shade/texture-inl.h"
#include "gw/fast/shade/with_r-inl.h"
#include "gw/stages/texgen.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE Sampler sampler_of(const DrawOp& op) {
    return {*op.texels, op.pairs, op.state.state.texture, op.state.bits};
}

/// Whether a unit of a draw is looked up as that of a draw with one texture of OpenGL 1.1.
HWY_INLINE bool is_plain_unit(const DrawOp& op, std::size_t number, const UnitOp& unit) {
    const TextureState& s = texture_of(op.state.state, number);
    return !unit.projective && !unit.texcoords->are_wide && !is_sprite(op.state.state, number) &&
           !has_rare_lookup(s, unit.texels->texels) && (unit.pairs || !reaches_border(s));
}
HWY_NOINLINE inline void sample_plain_unit(const TexturePlanes& p, const TexelValues& values,
                                           const TileDraw& draw, std::size_t number,
                                           const UnitOp& unit, int bx, int by, std::uint32_t mask,
                                           ColorBlock& out) {
    const Resolved& r = draw.op->state;
    const Sampler sampler{*unit.texels, unit.pairs, texture_of(r.state, number), r.bits};
    TextureLanes divided;
    ColorBlock found;
    divide_block(sampler, p, values, draw.tile, bx, by, mask, divided);
    sample_block(sampler, divided, mask, found);
    copy_lanes(found, mask, out);
}

/// Looks up the lanes of `mask`, which one primitive covers. Others of `out` stay.
HWY_NOINLINE inline void look_up_unit(const TexturePlanes& p, const TexelValues& values,
                                      const TileDraw& draw, std::size_t number, const UnitOp& unit,
                                      int bx, int by, std::uint32_t mask, ColorBlock& out) {
    const TextureState& state = texture_of(draw.op->state.state, number);
    if (compares_block(state, unit, p))
        compare_block(p, values, draw, number, unit, mask, out);
    else if (is_plain_unit(*draw.op, number, unit))
        sample_plain_unit(p, values, draw, number, unit, bx, by, mask, out);
    else if (looks_up_cube(state, unit.texels->texels, p))
        look_up_cube(p, values, draw, number, unit, bx, by, mask, out);
    else if (looks_up_with_r(state, unit.texels->texels, p))
        look_up_with_r(p, values, draw, number, unit, mask, out);
    else if (looks_up_sized(state, unit, p))
        look_up_sized(p, values, draw, number, unit, bx, by, mask, out);
    else
        sample_by_pixel(p, values, draw, number, unit, bx, by, mask, out);
}

/// The values of a unit's planes at a block's pixels.
HWY_INLINE void values_of(const TexturePlanes& p, const TextureState& state, const UnitOp& unit,
                          int bx, int by, TexelValues& out) {
    const bool has_r = state.shadow_compare || unit.texels->texels.with_r;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        const auto put = [&](const TilePlane& plane, std::int32_t* value) {
            hn::Store(hn::BitCast(I32(), wide_plane(plane, at)), I32(), value + i);
        };
        put(p.q, out.q);
        put(p.s.plane, out.s);
        put(p.t.plane, out.t);
        if (has_r) put(p.r.plane, out.r);
    }
}

/// Calls visit(number, unit, planes) for the units that are on.
template <class Visit>
HWY_INLINE void for_each_unit(const DrawOp& op, const TexturePlanes& p, const Visit& visit) {
    if (!op.units) return visit(0, {op.texels, op.texcoords, op.projective, op.pairs}, p);
    for (std::size_t number = 0; number < max_texture_units; ++number)
        if ((*op.units)[number].texels)
            visit(number, (*op.units)[number], number == 0 ? p : p.more[number - 1]);
}

/// Lanes of `mask` of a draw that textures by pixel.
HWY_NOINLINE inline void look_up_by_unit(const TexturePlanes& p, const TileDraw& draw, int bx,
                                         int by, std::uint32_t mask, TexelBlocks& out) {
    for_each_unit(
        *draw.op, p, [&](std::size_t number, const UnitOp& unit, const TexturePlanes& planes) {
            TexelValues values;
            values_of(planes, texture_of(draw.op->state.state, number), unit, bx, by, values);
            look_up_unit(planes, values, draw, number, unit, bx, by, mask, out[number]);
        });
}

/// Of each unit.
using UnitValues = std::array<TexelValues, max_texture_units>;
HWY_NOINLINE inline void look_up_by_unit(const TexturePlanes& p, const UnitValues& values,
                                         const TileDraw& draw, int bx, int by, std::uint32_t mask,
                                         TexelBlocks& out) {
    for_each_unit(
        *draw.op, p, [&](std::size_t number, const UnitOp& unit, const TexturePlanes& planes) {
            look_up_unit(planes, values[number], draw, number, unit, bx, by, mask, out[number]);
        });
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
