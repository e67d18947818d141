// Chooses the path of a bin's triangles: over uniform blocks, the simple path, or block by block
// through all fragment stages. docs/manual.md, "Stages"; scalar twin: gw/reference/primitives.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/draw.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/fragments/antialiased-inl.h"
#include "gw/fast/fragments/fragments-inl.h"
#include "gw/fast/fragments/sampled-inl.h"
#include "gw/fast/fragments/simple_triangles-inl.h"
#include "gw/fast/raster/lines_and_points-inl.h"
#include "gw/fast/tile/draw.h"
#include "gw/fast/uniform/uniform_draw-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Runs a covered block of primitive i through the stages. They make the colour when they need it.
HWY_INLINE void paint_block(BatchPlanes& planes, std::size_t i, const DepthBlock& depth, int bx,
                            int by, const LaneSet& lanes, OpCounts& counts) {
    const TileDraw& draw = planes.draw;
    const std::uint32_t covered = lanes.bits();
    run_fragments(draw.op->state, planes.corners.primitive[i]->front != 0, depth, draw.tile,
                  draw.tile.block(bx, by), covered, counts,
                  [&]() -> const ColorBlock& { return planes.color_of(i, bx, by, covered); });
}

void draw_triangles(const TileDraw& draw, std::span<const std::uint32_t> bin, OpCounts& counts) {
    Triangles t;
    const BoxLanes box(draw);
    set_up_triangles(draw, bin, needs_depth(*draw.op), t);
    BatchPlanes planes(draw, t.corners);
    for (std::size_t i = 0; i < t.count(); ++i) {
        if (t.empty(i)) continue;
        const DepthPlane plane = depth_of(draw, t, i);
        DepthWalk walk(plane, max_of_bits(draw.profile->depth_bits));
        const auto paint = [&](int bx, int by, const LaneSet& lanes) {
            DepthBlock depth;
            walk.store(depth);
            paint_block(planes, i, depth, bx, by, stippled(draw, bx, by, lanes), counts);
        };
        LargeTriangle::visit(box, t, i, walk, paint);
    }
}

HWY_INLINE void draw_line_or_point(BatchPlanes& planes, std::size_t i, OpCounts& counts) {
    const TileDraw& draw = planes.draw;
    const PrimitiveFrame frame = frame_of(draw, planes.corners.ordinal[i]);
    const SetupPrimitive& primitive = *planes.corners.primitive[i];
    const DepthPlane plane = depth_plane(draw, primitive, frame);
    const std::uint32_t most = max_of_bits(draw.profile->depth_bits);
    DepthBlock depth;
    visit_line_or_point(
        draw, frame,
        [&](int bx, int by, const LaneSet& lanes) {
            shade_depth(plane, most, bx, by, depth);
            paint_block(planes, i, depth, bx, by, lanes, counts);
        },
        [&](const PrimitiveFrame& at, int bx, int by, int lane) {
            shade_depth(depth_plane(draw, primitive, at), most, bx, by, depth);
            ShadeInputs in;
            const std::uint32_t mask = 1u << lane;
            run_fragments(draw.op->state, primitive.front != 0, depth, draw.tile,
                          draw.tile.block(bx, by), mask, counts, [&]() -> const ColorBlock& {
                              return outer_color(draw, primitive, at, bx, by, mask, in);
                          });
        });
}

/// A batch.
HWY_NOINLINE void draw_lines_and_points(const TileDraw& draw,
                                        std::span<const std::uint32_t> ordinals, OpCounts& counts) {
    Corners corners;
    gather_corners(draw, ordinals, corners);
    BatchPlanes planes(draw, corners);
    for (std::size_t i = 0; i < corners.count; ++i) draw_line_or_point(planes, i, counts);
}

/// Draws the primitives of a bin that may be antialiased.
HWY_NOINLINE void draw_smooth(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    OpCounts counts;
    write_back_tile(draw.tile, touched_planes(*draw.op));
    draw_antialiased(
        draw, bin, counts,
        [&](std::uint32_t ordinal) {
            draw_triangles(draw, {&ordinal, 1}, counts);
        },
        [&](std::uint32_t ordinal) {
            draw_lines_and_points(draw, {&ordinal, 1}, counts);
        });
    *draw.counts += counts;
}

void draw_all(const TileDraw& draw, std::span<const std::uint32_t> bin);

/// The same of a surface with samples. Without places of their own each is drawn as a surface.
HWY_NOINLINE void draw_samples(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    if (draw.op->state.state.multisample.enable) {
        for (const Tile& tile : draw.samples) write_back_tile(tile, touched_planes(*draw.op));
        return draw_sampled(draw, bin);
    }
    OpCounts counts;
    for (const Tile& tile : draw.samples) {
        counts.fragments = 0;
        TileDraw one = draw;
        one.tile = tile;
        one.samples = {};
        one.counts = &counts;
        draw_all(one, bin);
    }
    *draw.counts += counts;
}

/// Draws the primitives of a bin in order.
void draw_all(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    if (!draw.samples.empty()) return draw_samples(draw, bin);
    if (antialiases(*draw.op)) return draw_smooth(draw, bin);
    OpCounts counts;
    const bool uniform = draws_uniform(*draw.op, bin, draw.profile->subpixel_bits),
               simple = takes_simple_path(*draw.op);
    if (!uniform) write_back_tile(draw.tile, touched_planes(*draw.op));
    walk_bin(
        draw, bin,
        [&](std::span<const std::uint32_t> batch) {
            if (uniform ? draw_uniform(draw, batch, counts)
                        : simple && draw_simple(draw, batch, counts))
                return;
            write_back_tile(draw.tile, touched_planes(*draw.op));
            draw_triangles(draw, batch, counts);
        },
        [&](std::span<const std::uint32_t> batch) { draw_lines_and_points(draw, batch, counts); });
    *draw.counts += counts;
}

void process_block(const BlockFragments& f, const ColorBlock& color, const DepthBlock& depth,
                   const Tile& tile, OpCounts& counts) {
    if (f.state->samples > 1)
        return run_sample(*f.state, f.sample, f.front, depth, tile, f.block, f.mask, counts, color);
    run_fragments(*f.state, f.front, depth, tile, f.block, f.mask, counts,
                  [&]() -> const ColorBlock& { return color; });
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(draw_all);
HWY_EXPORT(process_block);

void draw_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    HWY_DYNAMIC_DISPATCH(draw_all)(draw, bin);
}

void process_fragments(const BlockFragments& f, const ColorBlock& color, const DepthBlock& depth,
                       const Tile& tile, OpCounts& counts) {
    HWY_DYNAMIC_DISPATCH(process_block)(f, color, depth, tile, counts);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
