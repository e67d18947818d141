// Coverage of triangles, lines and points in a tile, a block at a time, and the way of a block's fragments.
// docs/manual.md, "Coverage"; scalar twin: gw/reference/triangle.cpp. Does not plan or bin.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/raster.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/coverage.h"
#include "gw/fast/kernels.h"
#include "gw/fast/shade-inl.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Edge functions as vectors: c + a i + b j of a block's 16 lanes.
struct EdgeLanes {
    TileEdges edges;
    alignas(64) std::int32_t lane[3][16];
};

HWY_INLINE void make_edge_lanes(EdgeLanes& e) {
    const I32 d;
    const D32 u;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            const auto x = hn::BitCast(d, hn::Load(u, lane_x + i)),
                       y = hn::BitCast(d, hn::Load(u, lane_y + i));
            const auto v =
                hn::Add(hn::Mul(hn::Set(d, e.edges.a[k]), x), hn::Mul(hn::Set(d, e.edges.b[k]), y));
            hn::Store(v, d, e.lane[k] + i);
        }
}

/// Lanes of block (bx, by) whose centres are inside all three edges.
HWY_INLINE std::uint32_t covered(const EdgeLanes& e, int bx, int by) {
    const I32 d;
    const TileEdges& t = e.edges;
    std::int32_t base[3];
    for (std::size_t k = 0; k < 3; ++k)
        base[k] = t.c[k] + t.a[k] * (bx * block_side) + t.b[k] * (by * block_side);
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto e0 = hn::Add(hn::Set(d, base[0]), hn::Load(d, e.lane[0] + i));
        const auto e1 = hn::Add(hn::Set(d, base[1]), hn::Load(d, e.lane[1] + i));
        const auto e2 = hn::Add(hn::Set(d, base[2]), hn::Load(d, e.lane[2] + i));
        const auto outside = hn::Lt(hn::Or(hn::Or(e0, e1), e2), hn::Zero(d));  // any sign bit
        mask |= bits_of(D32(), hn::RebindMask(D32(), outside), lanes32) << i;
    }
    return ~mask & all_lanes;
}

/// A primitive in a tile, its planes made when the first of its fragments needs them.
struct Primitive {
    const TileDraw& draw;
    const SetupPrimitive& setup;
    const PrimitiveFrame& frame;
    DepthPlane depth;
    ColorPlanes color;
    TexturePlanes texture;
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
struct Painter {
    HWY_INLINE void operator()(Primitive& p, int bx, int by, std::uint32_t mask) const {
        const DrawOp& op = *p.draw.op;
        DepthBlock depth;
        ShadeInputs inputs;
        if (op.state.state.depth.func != DepthFunc::Always || op.state.state.depth.mask)
            p.depth_of(bx, by, depth);
        run_fragments(op.state, p.setup.front != 0, depth, p.draw.tile, p.draw.tile.block(bx, by), mask,
                      *p.draw.counts, [&]() -> const ColorBlock& { return p.color_of(bx, by, inputs); });
    }
};

/// A covered block of a record in the making: counted, and kept where its depth is the stored one.
struct Recorder {
    Coverage& record;

    HWY_INLINE void operator()(Primitive& p, int bx, int by, std::uint32_t mask) const {
        const D32 d;
        const std::size_t block = p.draw.tile.block(bx, by);
        for (std::size_t i = 0; i < block_pixels; i += lanes32) {
            std::uint32_t* count = record.fragments[block].value + i;
            const auto one = hn::IfThenElseZero(lanes_of(d, mask, i), hn::Set(d, 1u));
            hn::Store(hn::Add(hn::Load(d, count), one), d, count);
        }
        record.total += std::uint64_t(std::popcount(mask));
        DepthBlock depth;
        const std::uint32_t visible =
            depth_test(DepthFunc::Equal, p.depth_of(bx, by, depth), p.draw.tile.depth[block], mask);
        if (visible != 0)
            record.blocks.push_back(
                {std::uint16_t(block), std::uint16_t(visible), std::uint32_t(record.primitives.size())});
    }
};

/// Pixels of the tile that may be touched: [x0, x1) x [y0, y1).
struct PixelBounds {
    int x0, y0, x1, y1;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
};

HWY_INLINE PixelBounds bounds_in_tile(const TileDraw& draw, const PrimitiveFrame& f) {
    const auto [x_low, x_high] = std::minmax({f.x[0], f.x[1], f.x[2]});
    const auto [y_low, y_high] = std::minmax({f.y[0], f.y[1], f.y[2]});
    const std::int64_t half = std::int64_t{1} << (f.s - 1);
    const BlockBox& box = draw.box;
    const auto clamp = [](std::int64_t v, int low, int high) {
        return int(std::clamp<std::int64_t>(v, low, high));
    };
    return {clamp(((x_low + half - 1) >> f.s) - draw.tile.x, box.x0, box.x1),
            clamp(((y_low + half - 1) >> f.s) - draw.tile.y, box.y0, box.y1),
            clamp(((x_high - half) >> f.s) + 1 - draw.tile.x, box.x0, box.x1),
            clamp(((y_high - half) >> f.s) + 1 - draw.tile.y, box.y0, box.y1)};
}

template <class Visit>
HWY_INLINE void visit_triangle(Primitive& p, const Visit& visit) {
    const TileDraw& draw = p.draw;
    const PixelBounds b = bounds_in_tile(draw, p.frame);
    if (b.empty()) return;
    EdgeLanes edges;
    edges.edges = tile_edges(p.frame, draw.tile);
    make_edge_lanes(edges);
    for (int by = b.y0 / block_side; by <= (b.y1 - 1) / block_side; ++by)
        for (int bx = b.x0 / block_side; bx <= (b.x1 - 1) / block_side; ++bx) {
            const std::uint32_t mask = covered(edges, bx, by) & draw.box.mask(bx, by);
            if (mask != 0) visit(p, bx, by, mask);
        }
}

/// Pixels of a line or point, collected by block, then sent on in block order.
struct PixelSet {
    std::uint16_t mask[256] = {};
    int blocks_per_row = 16;
    void add(int x, int y) {
        auto& m = mask[std::size_t(y / block_side * blocks_per_row + x / block_side)];
        m = std::uint16_t(m | (1u << (y % block_side * block_side + x % block_side)));
    }
};

/// Rows from floor((v(p) - (width - 1) 2^(s-1)) / 2^s) in each column whose centre the line passes.
inline void line_pixels(const TileDraw& draw, const PrimitiveFrame& f, int width, PixelSet& out) {
    const int s = f.s;
    const auto& u = f.x_major ? f.x : f.y;
    const auto& v = f.x_major ? f.y : f.x;
    const int u_tile = f.x_major ? draw.tile.x : draw.tile.y, v_tile = f.x_major ? draw.tile.y : draw.tile.x;
    const BlockBox& b = draw.box;
    const int u0 = f.x_major ? b.x0 : b.y0, u1 = f.x_major ? b.x1 : b.y1, v0 = f.x_major ? b.y0 : b.x0,
              v1 = f.x_major ? b.y1 : b.x1;
    const std::int64_t du = u[1] - u[0], dv = v[1] - v[0], row = f.length << s;
    for (int i = u0; i < u1; ++i) {
        const std::int64_t p = (std::int64_t{u_tile + i} << s) + (std::int64_t{1} << (s - 1));
        if (du > 0 ? p < u[0] || p >= u[1] : p > u[0] || p <= u[1]) continue;
        const std::int64_t top = v[0] * f.length + (du > 0 ? dv : -dv) * (p - u[0]) - (width - 1) * row / 2;
        const std::int64_t first = (top >= 0 ? top / row : -((-top + row - 1) / row)) - v_tile;
        for (std::int64_t j = std::max<std::int64_t>(first, v0);
             j < std::min<std::int64_t>(first + width, v1); ++j)
            f.x_major ? out.add(i, int(j)) : out.add(int(j), i);
    }
}

inline void point_pixels(const TileDraw& draw, const PrimitiveFrame& f, int size, PixelSet& out) {
    const std::int64_t shift = (size - 1) * (std::int64_t{1} << (f.s - 1));
    const std::int64_t x = ((f.x[0] - shift) >> f.s) - draw.tile.x,
                       y = ((f.y[0] - shift) >> f.s) - draw.tile.y;
    const BlockBox& b = draw.box;
    for (std::int64_t j = std::max<std::int64_t>(y, b.y0); j < std::min<std::int64_t>(y + size, b.y1); ++j)
        for (std::int64_t i = std::max<std::int64_t>(x, b.x0); i < std::min<std::int64_t>(x + size, b.x1);
             ++i)
            out.add(int(i), int(j));
}

template <class Visit>
inline void visit_line_or_point(Primitive& p, const Visit& visit) {
    PixelSet pixels;
    pixels.blocks_per_row = p.draw.tile.side / block_side;
    const State& s = p.draw.op->state.state;
    if (p.setup.kind == MeshKind::Lines)
        line_pixels(p.draw, p.frame, s.line_width, pixels);
    else
        point_pixels(p.draw, p.frame, s.point_size, pixels);
    for (int block = 0; block < pixels.blocks_per_row * pixels.blocks_per_row; ++block)
        if (pixels.mask[block] != 0)
            visit(p, block % pixels.blocks_per_row, block / pixels.blocks_per_row, pixels.mask[block]);
}

/// Calls visit(primitive, bx, by, mask) for every covered block of a primitive.
template <class Visit>
HWY_INLINE void visit_primitive(Primitive& p, const Visit& visit) {
    if (p.setup.kind == MeshKind::Triangles)
        visit_triangle(p, visit);
    else
        visit_line_or_point(p, visit);
}

HWY_INLINE PrimitiveFrame frame_of(const TileDraw& draw, std::uint32_t ordinal) {
    const GeometrySet& set = *draw.op->set;
    return primitive_frame(set, set.primitives[ordinal], draw.op->state.state.jitter,
                           draw.profile->subpixel_bits, draw.tile);
}

void draw_all(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    for (const std::uint32_t ordinal : bin) {
        const PrimitiveFrame frame = frame_of(draw, ordinal);
        Primitive p{draw, draw.op->set->primitives[ordinal], frame, {}, {}, {}};
        visit_primitive(p, Painter{});
    }
}

/// Makes the record of a draw under Equal: its visible blocks, and how many fragments each pixel gets.
void record_all(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record) {
    record.fragments.assign(std::size_t(draw.tile.side) * std::size_t(draw.tile.side) / block_pixels,
                            DepthBlock{});
    for (const std::uint32_t ordinal : bin) {
        const PrimitiveFrame frame = frame_of(draw, ordinal);
        Primitive p{draw, draw.op->set->primitives[ordinal], frame, {}, {}, {}};
        const std::size_t before = record.blocks.size();
        visit_primitive(p, Recorder{record});
        if (record.blocks.size() != before) record.primitives.push_back({ordinal, frame});
    }
    // By block, in each block in the primitives' order.
    std::stable_sort(record.blocks.begin(), record.blocks.end(),
                     [](const VisibleBlock& a, const VisibleBlock& b) { return a.block < b.block; });
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

/// Makes the colour planes of the record's primitives, as this draw has them.
HWY_INLINE void color_planes(const TileDraw& draw, Coverage& record) {
    record.colors.resize(record.primitives.size());
    for (std::size_t i = 0; i < record.primitives.size(); ++i) {
        const VisiblePrimitive& v = record.primitives[i];
        make_color_planes(draw, draw.op->set->primitives[v.ordinal], v.frame, record.colors[i]);
    }
}

/// Makes or finds the texture planes of the record's primitives.
HWY_INLINE const TexturePlanes* texture_planes(const TileDraw& draw, Coverage& record) {
    const DrawOp& op = *draw.op;
    if (!op.texels) return nullptr;
    TextureState state = op.state.state.texture;
    state.env = TexEnv::Modulate, state.env_color = vec4(0);
    if (record.texcoords != op.texcoords || !(record.texture_state == state)) {
        record.texture.resize(record.primitives.size());
        for (std::size_t i = 0; i < record.primitives.size(); ++i) {
            const VisiblePrimitive& v = record.primitives[i];
            make_texture_planes(draw, op.set->primitives[v.ordinal], v.frame, record.texture[i]);
        }
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
