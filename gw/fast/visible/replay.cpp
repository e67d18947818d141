// Draws from a record of visible fragments, block by block, all primitives of a block at once. Does
// not find visibility.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/visible/replay.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/fragments/blend-inl.h"
#include "gw/fast/fragments/stencil-inl.h"
#include "gw/fast/shade/shade-inl.h"
#include "gw/fast/visible/visible_record.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The number of fragments that the stencil test kills, from the record's counts. All others are
/// killed by depth or visible.
HWY_INLINE std::uint64_t killed_by_stencil(const TileDraw& draw, const VisibleRecord& record) {
    const D32 d;
    const StencilFace& face = draw.op->state.front;
    if (face.func == StencilFunc::Always) return 0;
    std::uint64_t killed = 0;
    for (std::size_t block = 0; block < record.fragments.size(); ++block) {
        const std::uint32_t fails =
            all_lanes & ~stencil_test(face, draw.tile.stencil[block], all_lanes);
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

/// Makes the colour planes of the record's primitives for this draw.
HWY_INLINE void make_colors(const TileDraw& draw, bool narrow, VisibleRecord& record) {
    const std::size_t batches = record.batches();
    if (narrow && record.narrow.size() < batches) record.narrow.resize(batches);
    if (!narrow) record.colors.resize(record.primitives.size());
    for (std::size_t i = 0; i < batches; ++i) {
        Denominators shared;
        if (narrow)
            set_up_narrow(draw, record.corners[i], record.narrow[i]);
        else
            set_up_colors(draw, record.corners[i], shared,
                          record.colors.data() + i * batch_capacity);
    }
}

/// Whether black fragments change nothing but alpha: the draw adds colours, with black fog or none.
HWY_INLINE bool adds_light(const DrawOp& op) {
    const State& s = op.state.state;
    const Rgba& fog = op.state.fog_color;
    return s.blend.enable && adds_colors(s.blend) &&
           (!op.texels || s.texture.env == TexEnv::Modulate) &&
           (!has_fog(s) || (fog[0] | fog[1] | fog[2]) == 0);
}

/// Makes or keeps the texture planes of the record's primitives. Drops texels of another texture.
HWY_INLINE void make_textures(const TileDraw& draw, VisibleRecord& record) {
    const DrawOp& op = *draw.op;
    TextureCache& cache = record.texture;
    TextureState state = op.state.state.texture;
    state.env = TexEnv::Modulate;
    state.env_color = vec4(0);
    state.combine_rgb = state.combine_alpha = {};
    if (cache.texcoords == op.texcoords && cache.texels == op.texels && cache.state == state)
        return;
    cache.texcoords = op.texcoords;
    cache.texels = op.texels;
    cache.state = state;
    cache.planes.resize(record.primitives.size());
    cache.found.resize(record.runs.size());
    cache.made.assign(record.runs.size(), 0);
    for (std::size_t i = 0; i < record.batches(); ++i) {
        Denominators shared;
        set_up_textures(draw, record.corners[i], shared, cache.planes.data() + i * batch_capacity);
    }
}

/// Whether a textured draw only adds its modulated colour, in 8 bits: most passes of [K3].
HWY_INLINE bool adds_modulated(const Resolved& r) {
    const BlendState& b = r.state.blend;
    return r.bits == 8 && r.state.texture.env == TexEnv::Modulate && !has_fog(r.state) &&
           r.state.color_source != ColorSource::PolygonId && b.enable && adds_colors(b) &&
           r.writes_whole_color;
}
HWY_INLINE void add_modulated(const ColorBlock& color, const ColorBlock& texel, ColorBlock& stored,
                              std::uint32_t mask) {
    const D16 d;
    const auto max = hn::Set(d, std::uint16_t{255});
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        const auto lanes = lanes_of(d, mask, i);
        for (std::size_t c = 0; c < 4; ++c) {
            std::uint16_t* to = stored.channel[c] + i;
            const auto own =
                mul_bytes(d, hn::Load(d, color.channel[c] + i), hn::Load(d, texel.channel[c] + i));
            store_lanes(hn::Min(hn::Add(own, hn::Load(d, to)), max), lanes, d, to);
        }
    }
}

/// One draw from a record.
struct Replay {
    const TileDraw& draw;
    VisibleRecord& record;
    bool narrow, textured, by_pixel;
    std::size_t channels;
    bool adds_modulated, leaves_black;
    ShadeInputs inputs;

    HWY_INLINE int bx(const BlockRun& run) const {
        return run.block % (draw.tile.side / block_side);
    }
    HWY_INLINE int by(const BlockRun& run) const {
        return run.block / (draw.tile.side / block_side);
    }

    HWY_INLINE std::span<const VisibleBlock> entries(const BlockRun& run) const {
        return std::span(record.blocks).subspan(run.first, run.count);
    }

    template <std::size_t n>
    HWY_INLINE void narrow_colors_of(const BlockRun& run, std::span<const VisibleBlock> entries) {
        NarrowLanes<n> lanes;
        lanes.clear();
        for (const VisibleBlock& entry : entries)
            lanes.put(record.narrow[entry.primitive / batch_capacity],
                      entry.primitive % batch_capacity, lane_set(entry.mask));
        lanes.store(bx(run), by(run), inputs);
    }
    /// The colours of entries of one block that share no lane.
    HWY_INLINE void colors_of(const BlockRun& run, std::span<const VisibleBlock> entries) {
        if (!narrow) {
            for (const VisibleBlock& entry : entries)
                wide_colors(record.colors[entry.primitive], *draw.op, bx(run), by(run), entry.mask,
                            inputs);
        } else if (entries.size() == 1) {
            const std::uint32_t i = entries[0].primitive;
            narrow_colors(record.narrow[i / batch_capacity], i % batch_capacity, channels, bx(run),
                          by(run), inputs);
        } else {
            channels == 5 ? narrow_colors_of<5>(run, entries) : narrow_colors_of<4>(run, entries);
        }
    }
    HWY_INLINE const TexturePlanes& texture_of(const VisibleBlock& entry) const {
        return record.texture.planes[entry.primitive];
    }
    HWY_INLINE void look_up(const BlockRun& run, const VisibleBlock& entry, std::uint32_t mask) {
        gw::fast::HWY_NAMESPACE::look_up(texture_of(entry), draw, bx(run), by(run), mask, inputs);
    }
    HWY_INLINE void write(const BlockRun& run, const ColorBlock& texel, std::uint32_t mask) {
        ColorBlock& stored = draw.tile.color[run.block];
        if (adds_modulated) return add_modulated(inputs.color, texel, stored, mask);
        write_color(draw.op->state, shaded(draw, texel, inputs), stored, mask);
    }
    /// The run's texels, kept for the next draws.
    HWY_INLINE const ColorBlock& found(const BlockRun& run) {
        const auto i = std::size_t(&run - record.runs.data());
        TextureCache& cache = record.texture;
        if (!cache.made[i]) find(run, cache.found[i]);
        cache.made[i] = 1;
        return cache.found[i];
    }
    HWY_NOINLINE void find(const BlockRun& run, ColorBlock& out) {
        const Sampler sampler = sampler_of(*draw.op);
        const std::uint32_t mask = run.count == 1 ? entries(run)[0].mask : all_lanes;
        if (run.count == 1)
            divide_block(sampler, texture_of(entries(run)[0]), draw.tile, bx(run), by(run), mask,
                         inputs.divided);
        else {
            for (const VisibleBlock& entry : entries(run))
                texture_inputs(sampler, texture_of(entry), draw.tile, bx(run), by(run), entry.mask,
                               inputs.texture);
            divide_block(sampler, inputs.texture, inputs.divided);
        }
        sample_block(sampler, inputs.divided, mask, out);
    }

    /// Whether the run changes nothing: its colours are black and no alpha can grow.
    HWY_INLINE bool adds_nothing(const BlockRun& run, std::uint32_t mask) const {
        if (!leaves_black) return false;
        for (const VisibleBlock& entry : entries(run))
            if (!(record.narrow[entry.primitive / batch_capacity].black >>
                      entry.primitive % batch_capacity &
                  1))
                return false;
        return draw.op->state.written_bits[3] == 0 || is_opaque(draw.tile.color[run.block], mask);
    }
    /// Whether the lanes have the largest alpha.
    HWY_INLINE bool is_opaque(const ColorBlock& stored, std::uint32_t mask) const {
        const D16 d;
        const auto most = hn::Set(d, std::uint16_t(max_of_bits(draw.op->state.bits)));
        std::uint32_t opaque = 0;
        for (std::size_t i = 0; i < block_pixels; i += lanes16)
            opaque |= bits_of(d, hn::Eq(hn::Load(d, stored.channel[3] + i), most), lanes16) << i;
        return (mask & ~opaque) == 0;
    }

    /// A run without ties: every pixel has one primitive.
    HWY_INLINE void paint(const BlockRun& run, std::uint32_t mask) {
        colors_of(run, entries(run));
        if (by_pixel)
            for (const VisibleBlock& entry : entries(run)) look_up(run, entry, entry.mask & mask);
        write(run, textured && !by_pixel ? found(run) : inputs.texels[0], mask);
    }
    /// One primitive after the other: a pixel with a tie is written twice.
    HWY_INLINE void paint_tied(const BlockRun& run, std::uint32_t mask) {
        for (const VisibleBlock& entry : entries(run)) {
            const std::uint32_t own = entry.mask & mask;
            if (own == 0) continue;
            colors_of(run, std::span(&entry, 1));
            if (textured) look_up(run, entry, own);
            write(run, inputs.texels[0], own);
        }
    }
    /// The stencil operation of the visible fragments.
    HWY_INLINE void update_stencil(const BlockRun& run, std::uint32_t mask) const {
        const Resolved& r = draw.op->state;
        StencilBlock& stencil = draw.tile.stencil[run.block];
        const auto update = [&](std::uint32_t lanes) {
            HWY_NAMESPACE::update_stencil(r.front, r.front.zpass, r.stencil_max, stencil, lanes);
        };
        if (!run.tied) return update(mask);
        for (const VisibleBlock& entry : entries(run)) update(entry.mask & mask);
    }
    HWY_INLINE std::uint64_t fragments(const BlockRun& run, std::uint32_t mask) const {
        if (!run.tied) return std::uint64_t(std::popcount(mask));
        std::uint64_t sum = 0;
        for (std::uint32_t k = 0; k < run.count; ++k)
            sum += std::uint64_t(std::popcount(record.blocks[run.first + k].mask & mask));
        return sum;
    }
};

/// Draws from a record: visible blocks only, block by block.
void replay_all(const TileDraw& draw, VisibleRecord& record) {
    const DrawOp& op = *draw.op;
    OpCounts& counts = *draw.counts;
    const std::uint64_t killed = killed_by_stencil(draw, record);
    const bool colors = op.state.writes_color, textured = colors && op.texels != nullptr,
               narrow = is_narrow(op);
    if (colors) make_colors(draw, narrow, record);
    if (textured) make_textures(draw, record);
    Replay replay{draw,
                  record,
                  narrow,
                  textured,
                  textured && textures_by_pixel(op),
                  has_fog(op.state.state) ? std::size_t{5} : std::size_t{4},
                  textured && adds_modulated(op.state),
                  colors && narrow && adds_light(op),
                  {}};
    std::uint64_t written = 0;
    for (const BlockRun& run : record.runs) {
        const std::uint32_t mask =
            stencil_test(op.state.front, draw.tile.stencil[run.block], run.mask);
        if (mask == 0) continue;
        written += replay.fragments(run, mask);
        if (op.state.front.zpass != StencilOp::Keep) replay.update_stencil(run, mask);
        if (!colors || replay.adds_nothing(run, mask)) continue;
        if (run.tied)
            replay.paint_tied(run, mask);
        else
            replay.paint(run, mask);
    }
    counts.fragments += record.total;
    counts.stencil_killed += killed;
    counts.written += written;
    counts.depth_killed += record.total - killed - written;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(replay_all);

void replay_primitives(const TileDraw& draw, VisibleRecord& record) {
    HWY_DYNAMIC_DISPATCH(replay_all)(draw, record);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
