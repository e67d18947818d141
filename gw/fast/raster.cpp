// Drawing a bin of primitives in a tile: block by block through the fragment stages, or from a record.
// docs/manual.md, "Stages"; scalar twin: gw/reference/draw.cpp. Does not plan or bin.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/raster.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/kernels.h"
#include "gw/fast/record-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// A primitive in a tile, its planes made when the first of its fragments needs them.
struct Primitive {
    const TileDraw& draw;
    const SetupPrimitive& setup;
    const PrimitiveFrame& frame;
    ColorPlanes& color;  ///< room that one draw's primitives share
    TexturePlanes& texture;
    DepthPlane depth{};
    bool has_depth = false, has_color = false;

    HWY_INLINE const DepthBlock& depth_of(int bx, int by, DepthBlock& out) {
        if (!has_depth) depth = depth_plane(draw, setup, frame);
        has_depth = true;
        shade_depth(depth, max_of_bits(draw.profile->depth_bits), bx, by, out);
        return out;
    }
    HWY_INLINE const ColorBlock& color_of(int bx, int by, ShadeInputs& in) {
        if (!has_color) {
            make_color_planes(draw, setup, frame, color);
            if (draw.op->texels) make_texture_planes(draw, setup, frame, texture);
        }
        has_color = true;
        shade_inputs(color, texture, draw, bx, by, all_lanes, in);
        return shaded(draw, in);
    }
};

/// A covered block: depth, then the stages, which ask for the colour when they need it.
HWY_INLINE void paint_block(Primitive& p, int bx, int by, std::uint32_t mask) {
    const DrawOp& op = *p.draw.op;
    DepthBlock depth;
    ShadeInputs inputs;
    if (op.state.state.depth.func != DepthFunc::Always || op.state.state.depth.mask)
        p.depth_of(bx, by, depth);
    run_fragments(op.state, p.setup.front != 0, depth, p.draw.tile, p.draw.tile.block(bx, by), mask,
                  *p.draw.counts, [&]() -> const ColorBlock& { return p.color_of(bx, by, inputs); });
}

/// Draws the primitives of a bin in order.
void draw_all(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    ColorPlanes color;
    TexturePlanes texture;
    for (const std::uint32_t ordinal : bin) {
        const PrimitiveFrame frame = frame_of(draw, ordinal);
        Primitive p{draw, draw.op->set->primitives[ordinal], frame, color, texture};
        visit_primitive(draw, frame,
                        [&](int bx, int by, std::uint32_t mask) { paint_block(p, bx, by, mask); });
    }
}

void process_block(const BlockFragments& f, const ColorBlock& color, const DepthBlock& depth,
                   const Tile& tile, OpCounts& counts) {
    run_fragments(*f.state, f.front, depth, tile, f.block, f.mask, counts,
                  [&]() -> const ColorBlock& { return color; });
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(draw_all);
HWY_EXPORT(record_all);
HWY_EXPORT(replay_all);
HWY_EXPORT(process_block);

void draw_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage* record) {
    if (!record) return HWY_DYNAMIC_DISPATCH(draw_all)(draw, bin);
    if (!record->made) HWY_DYNAMIC_DISPATCH(record_all)(draw, bin, *record);
    HWY_DYNAMIC_DISPATCH(replay_all)(draw, *record);
}

void process_fragments(const BlockFragments& f, const ColorBlock& color, const DepthBlock& depth,
                       const Tile& tile, OpCounts& counts) {
    HWY_DYNAMIC_DISPATCH(process_block)(f, color, depth, tile, counts);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
