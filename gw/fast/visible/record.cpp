// Makes records of visible fragments: in a depth pass, or in the first pass under Equal.
// gw/fast/visible/replay.cpp draws from them. Does not decide which draws share a record.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/visible/record.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/fragments/simple_triangles-inl.h"
#include "gw/fast/raster/lines_and_points-inl.h"
#include "gw/fast/visible/visible_record.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Counts the fragments of a record: by pixel if a draw's stencil test needs it, else their sum.
struct FragmentCount {
    VisibleRecord& record;
    bool by_pixel;
    LaneCounter sum;

    FragmentCount(const TileDraw& draw, VisibleRecord& r)
        : record(r), by_pixel(draw.op->counts_by_pixel) {
        sum.clear();
        const auto side = std::size_t(draw.tile.side);
        if (by_pixel && record.fragments.empty())
            record.fragments.resize(side * side / block_pixels);
    }
    ~FragmentCount() { record.total += sum.total(); }

    HWY_INLINE void add(std::size_t block, const LaneSet& lanes) {
        const D32 d;
        sum.add(lanes);
        if (!by_pixel) return;
        for (std::size_t i = 0; i < parts; ++i) {
            std::uint32_t* count = record.fragments[block].value + i * lanes32;
            const auto one = hn::IfThenElseZero(lanes.part[i], hn::Set(d, 1u));
            hn::Store(hn::Add(hn::Load(d, count), one), d, count);
        }
    }
};

/// Adds a primitive's block to a record.
HWY_INLINE void keep(VisibleRecord& record, std::size_t block, std::uint32_t mask) {
    if (mask != 0)
        record.blocks.push_back(
            {std::uint16_t(block), std::uint16_t(mask), std::uint32_t(record.primitives.size())});
}
/// Ends a primitive. Keeps it if any of its blocks was kept, and returns whether it did.
HWY_INLINE bool keep_primitive(VisibleRecord& record, std::uint32_t ordinal,
                               std::size_t blocks_before) {
    if (record.blocks.size() == blocks_before) return false;
    record.primitives.push_back(ordinal);
    return true;
}

/// The lanes of one primitive's block that have the stored depth.
HWY_INLINE std::uint32_t visible_lanes(const TileDraw& draw, const DepthBlock& depth,
                                       std::size_t block, std::uint32_t mask) {
    return depth_test(DepthFunc::Equal, depth, draw.tile.depth[block], mask);
}

void record_triangles(const TileDraw& draw, std::span<const std::uint32_t> bin,
                      VisibleRecord& record) {
    Triangles t;
    set_up_triangles(draw, bin, true, t);
    const BoxLanes box(draw);
    FragmentCount count(draw, record);
    for (std::size_t i = 0; i < t.count(); ++i) {
        if (t.empty(i)) continue;
        const DepthPlane plane = depth_of(draw, t, i);
        DepthWalk walk(plane, max_of_bits(draw.profile->depth_bits));
        const std::size_t before = record.blocks.size();
        const auto visit = [&](int bx, int by, const LaneSet& lanes) {
            const std::size_t block = draw.tile.block(bx, by);
            DepthBlock depth;
            walk.store(depth);
            count.add(block, lanes);
            keep(record, block, visible_lanes(draw, depth, block, lanes.bits()));
        };
        by_size(t, i, [&]<class Size>(Size) { Size::visit(box, t, i, walk, visit); });
        keep_primitive(record, bin[i], before);
    }
}

void record_line_or_point(const TileDraw& draw, std::uint32_t ordinal, VisibleRecord& record) {
    const PrimitiveFrame frame = frame_of(draw, ordinal);
    const DepthPlane plane = depth_plane(draw, draw.op->set->primitives[ordinal], frame);
    const std::size_t before = record.blocks.size();
    FragmentCount count(draw, record);
    visit_line_or_point(draw, frame, [&](int bx, int by, const LaneSet& lanes) {
        const std::size_t block = draw.tile.block(bx, by);
        DepthBlock depth;
        shade_depth(plane, max_of_bits(draw.profile->depth_bits), bx, by, depth);
        count.add(block, lanes);
        keep(record, block, visible_lanes(draw, depth, block, lanes.bits()));
    });
    keep_primitive(record, ordinal, before);
}

/// Draws the blocks of a depth pass. Every lane that passes may stay visible, and so may every tie
/// with the stored depth.
template <class Paint>
struct Recording {
    Tile tile;
    const Paint paint;
    const DepthWalk& walk;
    bool ties_pass;
    FragmentCount& count;
    LaneCounter& written;

    GW_PER_BLOCK void operator()(int bx, int by, const LaneSet& lanes) const {
        const D32 d;
        const std::size_t block = tile.block(bx, by);
        LaneSet reached, passed;
        for (std::size_t k = 0; k < parts; ++k) {
            std::uint32_t* at = tile.depth[block].value + k * lanes32;
            const auto z = walk.walk.at(k), stored = hn::Load(d, at);
            reached.part[k] = hn::And(lanes.part[k], hn::Not(hn::Lt(stored, z)));
            passed.part[k] =
                ties_pass ? reached.part[k] : hn::And(lanes.part[k], hn::Lt(z, stored));
            store_lanes(z, passed.part[k], d, at);
        }
        count.add(block, lanes);
        written.add(passed);
        keep(count.record, block, reached.bits());
        paint(bx, by, passed);
    }
};

template <class Size, class Paint>
HWY_NOINLINE void draw_recording(const TileDraw& draw, const Triangles& t, std::size_t i,
                                 const BoxLanes& box, const Paint& paint, FragmentCount& count,
                                 LaneCounter& written) {
    const DepthPlane plane = depth_of(draw, t, i);
    DepthWalk walk(plane);
    VisibleRecord& record = count.record;
    const bool ties_pass = draw.op->state.state.depth.func == DepthFunc::LEqual;
    const std::size_t before = record.blocks.size();
    Size::visit(box, t, i, walk,
                Recording<Paint>{draw.tile, paint, walk, ties_pass, count, written});
    if (keep_primitive(record, t.corners.ordinal[i], before)) record.depth.push_back(plane.plane);
}

void draw_recording_all(const TileDraw& draw, std::span<const std::uint32_t> bin,
                        VisibleRecord& record) {
    const BoxLanes box(draw);
    const Paints paints = paints_of(*draw.op);
    LaneCounter written;
    written.clear();
    for (; !bin.empty(); bin = bin.subspan(std::min(bin.size(), batch_capacity))) {
        Triangles t;
        set_up_triangles(draw, bin, true, t);
        BatchPlanes planes(draw, t.corners);
        FragmentCount count(draw, record);
        for (std::size_t i = 0; i < t.count(); ++i)
            if (!t.empty(i))
                with_paint(paints, planes, i, [&](const auto& paint) {
                    by_size(t, i, [&]<class Size>(Size) {
                        draw_recording<Size>(draw, t, i, box, paint, count, written);
                    });
                });
    }
    record.drawn = true;
    const std::uint64_t passed = written.total();
    draw.counts->fragments += record.total;
    draw.counts->written += passed;
    draw.counts->depth_killed += record.total - passed;
}

/// Keeps those fragments of a depth pass that are still visible.
inline void drop_hidden(const TileDraw& draw, VisibleRecord& record) {
    const int blocks_per_row = draw.tile.side / block_side;
    std::size_t blocks = 0, primitives = 0;
    std::uint32_t last = ~0u;
    for (const VisibleBlock v : record.blocks) {
        DepthBlock depth;
        shade_depth({record.depth[v.primitive], 0}, 0, v.block % blocks_per_row,
                    v.block / blocks_per_row, depth);
        const std::uint32_t mask = visible_lanes(draw, depth, v.block, v.mask);
        if (mask == 0) continue;
        if (v.primitive != last) record.primitives[primitives++] = record.primitives[v.primitive];
        last = v.primitive;
        record.blocks[blocks++] = {v.block, std::uint16_t(mask), std::uint32_t(primitives - 1)};
    }
    record.blocks.resize(blocks);
    record.primitives.resize(primitives);
}

/// Adds the run of a block's entries first .. end - 1. Copies member by member: a copy of the whole
/// would wait for its parts to be stored.
inline void add_run(VisibleRecord& record, std::size_t block, std::uint32_t first,
                    std::uint32_t end) {
    std::uint32_t mask = 0, twice = 0;
    for (std::uint32_t i = first; i < end; ++i) {
        const std::uint32_t own = record.blocks[i].mask;
        twice |= mask & own;
        mask |= own;
    }
    BlockRun& run = record.runs.emplace_back();
    run.block = std::uint16_t(block);
    run.mask = std::uint16_t(mask);
    run.tied = twice != 0;
    run.first = first;
    run.count = end - first;
}

/// Sorts the entries by block, in each block in the primitives' order, and finds the blocks' runs.
inline void sort_blocks(VisibleRecord& record) {
    std::array<std::uint32_t, max_tile_blocks + 1> start{};
    for (const VisibleBlock& v : record.blocks) start[v.block + 1u] += 1;
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<VisibleBlock>& sorted = record.by_block;
    sorted.resize(record.blocks.size());
    std::array<std::uint32_t, max_tile_blocks + 1> next = start;
    for (const VisibleBlock& v : record.blocks) sorted[next[v.block]++] = v;
    record.blocks.swap(sorted);
    for (std::size_t block = 0; block < max_tile_blocks; ++block)
        if (start[block] != start[block + 1])
            add_run(record, block, start[block], start[block + 1]);
}

/// Makes the record of a draw under Equal: its visible blocks, their primitives' corners, and the
/// number of fragments.
void record_all(const TileDraw& draw, std::span<const std::uint32_t> bin, VisibleRecord& record) {
    if (record.drawn)
        drop_hidden(draw, record);
    else
        walk_bin(
            draw, bin,
            [&](std::span<const std::uint32_t> batch) { record_triangles(draw, batch, record); },
            [&](std::span<const std::uint32_t> batch) {
                for (const std::uint32_t ordinal : batch)
                    record_line_or_point(draw, ordinal, record);
            });
    sort_blocks(record);
    if (record.corners.size() < record.batches()) record.corners.resize(record.batches());
    for (std::size_t i = 0; i < record.batches(); ++i)
        gather_corners(draw, std::span(record.primitives).subspan(i * batch_capacity),
                       record.corners[i]);
    record.made = true;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(draw_recording_all);
HWY_EXPORT(record_all);

void VisibleRecord::clear() {
    drawn = made = false;
    primitives.clear();
    depth.clear();
    blocks.clear();
    fragments.clear();
    total = 0;
    runs.clear();
    texture.texcoords = nullptr;
}

void draw_recording(const TileDraw& draw, std::span<const std::uint32_t> bin,
                    VisibleRecord& record) {
    HWY_DYNAMIC_DISPATCH(draw_recording_all)(draw, bin, record);
}

void record_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin,
                       VisibleRecord& record) {
    HWY_DYNAMIC_DISPATCH(record_all)(draw, bin, record);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
