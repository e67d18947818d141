// Records of visible fragments: made by the first pass under Equal, drawn from by it and all later ones.
// gw/fast/coverage.h says when. Does not decide which draws share a record.
// Included once per Highway target.
#if defined(GW_FAST_RECORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_RECORD_INL_H_
#undef GW_FAST_RECORD_INL_H_
#else
#define GW_FAST_RECORD_INL_H_
#endif

#include "gw/fast/attributes-inl.h"
#include "gw/fast/cover-inl.h"
#include "gw/fast/coverage.h"
#include "gw/fast/shade-inl.h"

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

/// Makes the record of a draw under Equal: its visible blocks, and how many fragments each pixel gets.
void record_all(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record) {
    record.fragments.assign(std::size_t(draw.tile.side) * std::size_t(draw.tile.side) / block_pixels,
                            DepthBlock{});
    walk_bin(
        draw, bin, [&](std::span<const std::uint32_t> batch) { record_triangles(draw, batch, record); },
        [&](std::uint32_t ordinal) { record_line_or_point(draw, ordinal, record); });
    // By block, in each block in the primitives' order.
    std::stable_sort(record.blocks.begin(), record.blocks.end(),
                     [](const VisibleBlock& a, const VisibleBlock& b) { return a.block < b.block; });
    for (const DepthBlock& block : record.fragments)
        for (const std::uint32_t n : block.value) record.total += n;
    record.made = true;
}

/// Fragments of all blocks that the stencil test kills, from the counts; the others die by depth or are
/// visible.
HWY_INLINE std::uint64_t killed_by_stencil(const TileDraw& draw, const Coverage& record) {
    const D32 d;
    const StencilFace& face = draw.op->state.front;
    if (face.func == StencilFunc::Always) return 0;
    std::uint64_t killed = 0;
    for (std::size_t block = 0; block < record.fragments.size(); ++block) {
        const std::uint32_t fails = all_lanes & ~stencil_test(face, draw.tile.stencil[block], all_lanes);
        if (fails == 0) continue;
        alignas(64) std::uint32_t kept[block_pixels];
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            const auto n = hn::Load(d, record.fragments[block].value + i);
            hn::Store(hn::IfThenElseZero(lanes_of(d, fails, i), n), d, kept + i);
        }
        for (const std::uint32_t n : kept) killed += n;
    }
    return killed;
}

/// Calls make(corners, first) for the record's primitives, a batch at a time.
template <class Make>
HWY_INLINE void for_each_batch(const TileDraw& draw, const Coverage& record, const Make& make) {
    const std::span<const std::uint32_t> ordinals(record.primitives);
    for (std::size_t first = 0; first < ordinals.size(); first += batch_room) {
        Corners corners;
        gather_corners(draw, ordinals.subspan(first), corners);
        make(corners, first);
    }
}

/// Makes the colour planes of the record's primitives, as this draw has them.
HWY_INLINE void color_planes(const TileDraw& draw, Coverage& record) {
    record.colors.resize(record.primitives.size());
    for_each_batch(draw, record, [&](const Corners& corners, std::size_t first) {
        set_up_colors(draw, corners, record.colors.data() + first);
    });
}

/// Makes or finds the texture planes of the record's primitives.
HWY_INLINE const TexturePlanes* texture_planes(const TileDraw& draw, Coverage& record) {
    const DrawOp& op = *draw.op;
    if (!op.texels) return nullptr;
    TextureState state = op.state.state.texture;
    state.env = TexEnv::Modulate, state.env_color = vec4(0);
    if (record.texcoords != op.texcoords || !(record.texture_state == state)) {
        record.texture.resize(record.primitives.size());
        for_each_batch(draw, record, [&](const Corners& corners, std::size_t first) {
            set_up_textures(draw, corners, record.texture.data() + first);
        });
        record.texcoords = op.texcoords;
        record.texture_state = state;
    }
    return record.texture.data();
}

/// Colours of one block, gathered from its primitives and written together; a pixel where two tie is written
/// twice.
struct BlockColors {
    const TileDraw& draw;
    std::size_t block = 0;
    std::uint32_t mask = 0;
    ShadeInputs inputs;

    HWY_INLINE void flush() {
        if (mask != 0) write_color(draw.op->state, shaded(draw, inputs), draw.tile.color[block], mask);
        mask = 0;
    }
    HWY_INLINE void add(std::size_t to_block, std::uint32_t lanes, const ColorPlanes& planes,
                        const TexturePlanes& texture) {
        if (to_block != block || (mask & lanes) != 0) flush();
        block = to_block;
        mask |= lanes;
        const int row = draw.tile.side / block_side;
        shade_inputs(planes, texture, draw, int(block) % row, int(block) / row, lanes, inputs);
    }
};

/// Draws from a record: visible blocks only, block by block.
void replay_all(const TileDraw& draw, Coverage& record) {
    const DrawOp& op = *draw.op;
    OpCounts& counts = *draw.counts;
    const std::uint64_t killed = killed_by_stencil(draw, record);
    const bool colors = op.state.writes_color;
    const TexturePlanes* texture = colors ? texture_planes(draw, record) : nullptr;
    if (colors) color_planes(draw, record);
    static const TexturePlanes no_texture{};
    std::uint64_t written = 0;
    BlockColors out{draw, 0, 0, {}};
    for (const VisibleBlock& visible : record.blocks) {
        const std::uint32_t mask =
            stencil_test(op.state.front, draw.tile.stencil[visible.block], visible.mask);
        written += std::uint64_t(std::popcount(mask));
        if (mask == 0 || !colors) continue;
        const std::size_t k = visible.primitive;
        out.add(visible.block, mask, record.colors[k], texture ? texture[k] : no_texture);
    }
    out.flush();
    counts.fragments += record.total;
    counts.stencil_killed += killed;
    counts.written += written;
    counts.depth_killed += record.total - killed - written;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
