// A batch's colour and texture planes, made when a fragment first needs them. Does not test or
// write. Included once per Highway target.
#if defined(GW_FAST_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_BATCH_INL_H_
#undef GW_FAST_BATCH_INL_H_
#else
#define GW_FAST_BATCH_INL_H_
#endif

#include "gw/fast/shade/given_fog-inl.h"
#include "gw/fast/shade/modulate-inl.h"
#include "gw/fast/shade/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

struct BatchPlanes {
    const TileDraw& draw;
    const Corners& corners;
    BatchScratch& scratch;
    bool narrow, flat, modulates, made = false;
    std::size_t channels;
    NarrowBatch narrow_color;
    ShadeInputs in;
    std::size_t flat_in = batch_capacity;  ///< the triangle whose one colour is in `in`
    ModulatedTexels modulated;
    PerspectiveColors perspective;
    TexelQueue* queue = nullptr;  ///< of texels that are looked up later; null: at once

    HWY_INLINE BatchPlanes(const TileDraw& d, const Corners& c)
        : draw(d),
          corners(c),
          scratch(*d.scratch),
          narrow(is_narrow(*d.op)),
          flat(narrow && is_flat(*d.op) && !has_fog(d.op->state.state)),
          modulates(ModulatedTexels::applies_to(*d.op)),
          channels(has_fog(d.op->state.state) ? 5 : 4) {}

    HWY_INLINE void make() {
        if (!made) make_all();
    }
    HWY_NOINLINE void make_all() {
        made = true;
        Denominators shared;
        if (narrow)
            set_up_narrow(draw, corners, narrow_color);
        else
            set_up_colors(draw, corners, shared, scratch.color);
        if (draw.op->texels) set_up_textures(draw, corners, shared, scratch.texture);
        if (draw.op->sums_colors) set_up_secondary(draw, corners, shared, scratch.secondary);
        if (draw.op->direct_fog) make_given_fog();
    }
    HWY_NOINLINE void make_given_fog() {
        for (std::size_t i = 0; i < corners.count; ++i)
            scratch.fog[i] =
                given_fog(draw, *corners.primitive[i], frame_of(draw, corners.ordinal[i]));
    }
    HWY_INLINE void evaluate(std::size_t i, int bx, int by, std::uint32_t mask) {
        if (!narrow && !scratch.color[i].perspective)
            return wide_colors(scratch.color[i], *draw.op, bx, by, mask, in);
        if (narrow) {
            narrow_colors(narrow_color, i, channels, bx, by, in);
            flat_in = i;
        } else
            perspective_colors(i, bx, by);
    }
    HWY_INLINE void perspective_colors(std::size_t i, int bx, int by) {
        const ColorPlanes& planes = scratch.color[i];
        perspective.aim(planes, i);
        perspective.at(planes, draw.op->state.bits, bx, by,
                       [&](std::size_t c, std::size_t part, V32 value) {
                           store16(value, in.color.channel[c] + part * lanes32);
                       });
        if (channels == 5) wide_fog(planes, *draw.op, bx, by, all_lanes, in);
    }
    /// The colours of triangle i in a block, of the lanes of `mask`.
    HWY_NOINLINE const ColorBlock& color_of(std::size_t i, int bx, int by, std::uint32_t mask) {
        make();
        if (modulates) {
            modulated.write(draw, narrow_color, scratch.texture[i], i, bx, by, mask, in.out);
            return in.out;
        }
        if (draw.op->texels) look_up(scratch.texture[i], draw, bx, by, mask, in);
        return textured_color(i, bx, by, mask);
    }
    /// The same if `in` has the texels.
    HWY_INLINE const ColorBlock& textured_color(std::size_t i, int bx, int by, std::uint32_t mask) {
        if (!flat || flat_in != i) evaluate(i, bx, by, mask);
        if (draw.op->sums_colors)
            interpolated_color(scratch.secondary[i], draw.op->state.bits, bx, by, mask,
                               in.secondary);
        if (draw.op->direct_fog) find_given_fog_lanes(scratch.fog[i], draw, bx, by, mask, in.fog);
        return shaded(draw, in.texels[0], in);
    }
    /// Whether texels can be looked up for several blocks at once.
    HWY_INLINE bool may_queue() const {
        return draw.op->texels && !modulates && !textures_by_pixel(*draw.op);
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
