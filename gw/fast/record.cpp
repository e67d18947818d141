// Records of visible fragments, made by the first pass under Equal; gw/fast/coverage.h says when,
// gw/fast/replay.cpp draws from them. Does not decide which draws share a record.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/record.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/cover-inl.h"
#include "gw/fast/coverage.h"
#include "gw/fast/kernels.h"
#include "gw/fast/shade-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// A covered block of a record in the making: counted, and kept where its depth is the stored one.
HWY_INLINE void record_block(const TileDraw& draw, const DepthBlock& depth, std::size_t block,
                             const LaneSet& lanes, Coverage& record) {
    const D32 d;
    for (std::size_t i = 0; i < parts; ++i) {
        std::uint32_t* count = record.fragments[block].value + i * lanes32;
        const auto one = hn::IfThenElseZero(lanes.part[i], hn::Set(d, 1u));
        hn::Store(hn::Add(hn::Load(d, count), one), d, count);
    }
    const std::uint32_t visible = depth_test(DepthFunc::Equal, depth, draw.tile.depth[block], lanes.bits());
    if (visible != 0)
        record.blocks.push_back(
            {std::uint16_t(block), std::uint16_t(visible), std::uint32_t(record.primitives.size())});
}

/// Where a primitive of a record in the making is done: kept when some block shows it.
HWY_INLINE void keep_if_visible(std::uint32_t ordinal, std::size_t blocks_before, Coverage& record) {
    if (record.blocks.size() != blocks_before) record.primitives.push_back(ordinal);
}

void record_triangles(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record) {
    Triangles t;
    set_up_triangles(draw, bin, true, t);
    const BoxLanes box(draw);
    for (std::size_t i = 0; i < t.count(); ++i) {
        if (t.empty(i)) continue;
        const DepthPlane plane = depth_of(draw, t, i);
        DepthWalk walk{plane, max_of_bits(draw.profile->depth_bits), {}};
        const std::size_t before = record.blocks.size();
        visit_triangle(box, t, i, walk, [&](int bx, int by, const LaneSet& lanes) {
            DepthBlock depth;
            walk.store(depth);
            record_block(draw, depth, draw.tile.block(bx, by), lanes, record);
        });
        keep_if_visible(bin[i], before, record);
    }
}

void record_line_or_point(const TileDraw& draw, std::uint32_t ordinal, Coverage& record) {
    const PrimitiveFrame frame = frame_of(draw, ordinal);
    const DepthPlane plane = depth_plane(draw, draw.op->set->primitives[ordinal], frame);
    const std::size_t before = record.blocks.size();
    visit_line_or_point(draw, frame, [&](int bx, int by, const LaneSet& lanes) {
        DepthBlock depth;
        shade_depth(plane, max_of_bits(draw.profile->depth_bits), bx, by, depth);
        record_block(draw, depth, draw.tile.block(bx, by), lanes, record);
    });
    keep_if_visible(ordinal, before, record);
}

/// Sorts the entries by block, in each block in the primitives' order, and finds the blocks' runs.
inline void sort_blocks(Coverage& record) {
    std::array<std::uint32_t, max_tile_blocks + 1> start{};
    for (const VisibleBlock& v : record.blocks) start[v.block + 1u] += 1;
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<VisibleBlock> sorted(record.blocks.size());
    std::array<std::uint32_t, max_tile_blocks + 1> next = start;
    for (const VisibleBlock& v : record.blocks) sorted[next[v.block]++] = v;
    record.blocks.swap(sorted);
    for (std::size_t block = 0; block < max_tile_blocks; ++block) {
        BlockRun run{std::uint16_t(block), 0, false, start[block], start[block + 1] - start[block]};
        for (std::uint32_t i = 0; i < run.count; ++i) {
            const std::uint16_t mask = record.blocks[run.first + i].mask;
            run.tied = run.tied || (run.mask & mask) != 0;
            run.mask = std::uint16_t(run.mask | mask);
        }
        if (run.count != 0) record.runs.push_back(run);
    }
}

/// Makes the record of a draw under Equal: its visible blocks, and how many fragments each pixel gets.
void record_all(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record) {
    record.fragments.assign(std::size_t(draw.tile.side) * std::size_t(draw.tile.side) / block_pixels,
                            DepthBlock{});
    walk_bin(
        draw, bin, [&](std::span<const std::uint32_t> batch) { record_triangles(draw, batch, record); },
        [&](std::uint32_t ordinal) { record_line_or_point(draw, ordinal, record); });
    sort_blocks(record);
    for (const DepthBlock& block : record.fragments)
        for (const std::uint32_t n : block.value) record.total += n;
    record.made = true;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(record_all);

void record_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record) {
    HWY_DYNAMIC_DISPATCH(record_all)(draw, bin, record);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
