#include "gw/fast/tile/tile_run.h"

#include "gw/base/parallel.h"
#include "gw/fast/shade/repeated_texels.h"
#include "gw/fast/tile/accumulate.h"
#include "gw/fast/tile/clear.h"
#include "gw/fast/tile/draw.h"
#include "gw/fast/tile/draw_pixels.h"
#include "gw/fast/tile/read.h"
#include "gw/fast/vertices/geometry.h"
#include "gw/fast/visible/visible_record.h"
#include "gw/stages/accumulation.h"
#include "gw/stages/tables.h"

#include <algorithm>
#include <array>
#include <bit>
#include <deque>

namespace gw::fast {

/// The records of the tile in progress, by number.
class TileRecords {
public:
    VisibleRecord& operator[](int number) {
        const auto i = std::size_t(number);
        if (i >= place_.size()) place_.resize(std::max(i + 1, 2 * place_.size()));
        if (place_[i] == 0) {
            numbers_.push_back(i);
            place_[i] = std::uint32_t(numbers_.size());
            if (records_.size() < numbers_.size()) records_.emplace_back();
        }
        return records_[place_[i] - 1];
    }
    void clear() {
        for (std::size_t k = 0; k < numbers_.size(); ++k) {
            place_[numbers_[k]] = 0;
            records_[k].clear();
        }
        numbers_.clear();
    }
    /// Frees memory that segments with more records needed.
    void trim(std::size_t records) {
        if (place_.size() <= 8 * records + 64) return;
        place_ = {};
        records_.clear();
    }

private:
    std::vector<std::uint32_t> place_;  ///< by number: one more than the index in records_, or 0
    std::vector<std::size_t> numbers_;  ///< of records_
    std::deque<VisibleRecord> records_;
};

struct TileScratch {
    TileRecords records;
    BatchScratch batch;
    RepeatedTexels texels;
    std::vector<OpCounts> counts;  ///< by slot
};

namespace {

constexpr std::uint32_t every_lane = 0xFFFF;

/// Most blocks are full; portable popcount is a function call.
std::uint64_t lane_count(std::uint32_t mask) {
    return mask == every_lane ? block_pixels : std::uint64_t(std::popcount(mask));
}

/// Calls visit(block, bx, by, mask) for each block of a box that has lanes inside.
template <typename Visit>
void for_each_block(const Tile& tile, const BlockBox& box, const Visit& visit) {
    if (box.empty()) return;
    for (int by = box.y0 / block_side; by <= (box.y1 - 1) / block_side; ++by)
        for (int bx = box.x0 / block_side; bx <= (box.x1 - 1) / block_side; ++bx)
            visit(tile.block(bx, by), bx, by, box.mask(bx, by));
}

/// Calls visit(lane, x, y) for the lanes of a mask; x, y in the window.
template <typename Visit>
void for_each_lane(const Tile& tile, int bx, int by, std::uint32_t mask, const Visit& visit) {
    for (; mask != 0; mask &= mask - 1) {
        const auto lane = std::size_t(std::countr_zero(mask));
        visit(lane, tile.x + bx * block_side + int(lane % block_side),
              tile.y + by * block_side + int(lane / block_side));
    }
}

/// The channels of a block's pixels side by side.
auto pixels_of(const AccumBlock& block) {
    std::array<std::array<std::int32_t, 4>, block_pixels> out;
    for (std::size_t i = 0; i < block_pixels; ++i)
        for (std::size_t c = 0; c < 4; ++c) out[i][c] = block.channel[c][i];
    return out;
}

struct TileRun {
    const Profile& profile;
    Tile tile;
    TileScratch& scratch;
    std::span<const Tile> samples{};  ///< the tile of each sample; none without samples
    int sample = 0;                   ///< that `tile` is of
    OpCounts* counts = nullptr;
    Rect last_rect{};
    BlockBox last_box = block_box(last_rect, tile);

    /// Most operations have the rectangle of the previous one.
    const BlockBox& box(const Rect& rect) {
        if (!(rect == last_rect)) {
            last_rect = rect;
            last_box = block_box(rect, tile);
        }
        return last_box;
    }

    /// Runs an operation on all samples. Its fragments and pixels count once.
    void run_on_samples(const auto& op) {
        if (samples.empty()) return run(op);
        OpCounts all, *const sum = counts;
        counts = &all;
        for (sample = 0; sample < int(samples.size()); ++sample) {
            tile = samples[std::size_t(sample)];
            all.fragments = all.pixels = 0;
            run(op);
        }
        counts = sum;
        *counts += all;
    }
    void run_on_samples(const DrawOp& op) { run(op); }

    void run(const DrawOp& op) {
        const std::span<const std::uint32_t> bin =
            op.group->tile_bin(tile.x / tile.side, tile.y / tile.side);
        const TileDraw draw{
            &op,    &profile, tile, box(op.state.draw_box), counts, &scratch.batch, &scratch.texels,
            samples};
        if (draw.box.empty()) return;
        if (op.visible_record < 0) return draw_primitives(draw, bin);
        write_back_blocks(tile, touched_planes(op));
        VisibleRecord& record = scratch.records[op.visible_record];
        if (op.state.state.depth.func != DepthFunc::Equal) return draw_recording(draw, bin, record);
        if (!record.made) record_primitives(draw, bin, record);
        replay_primitives(draw, record);
    }

    void run(const ClearOp& op) {
        const Resolved& r = op.state;
        const BlockBox inside = box(r.pixel_box);
        if (inside.empty()) return;
        counts->pixels += pixels_in(inside) * std::uint64_t(std::popcount(op.planes));
        const auto wants = [&](Plane plane) { return (op.planes & mask_of(plane)) != 0; };
        ClearBlocks clear{tile, inside};
        if (wants(Plane::Color)) {
            clear.written_bits = r.written_bits;
            clear.clears_color = r.writes_whole_color;
        }
        clear.clears_depth = wants(Plane::Depth) && r.depth_mask;
        clear.color = quantize_color(op.clear->color, r.bits);
        clear.depth = quantize(op.clear->depth, profile.depth_bits);
        if (wants(Plane::Color) || clear.clears_depth) clear_blocks(clear);
        if (wants(Plane::Color) && draws_to_both(r.state)) clear_other_color(clear);
        if (wants(Plane::Stencil) || wants(Plane::Accum))
            clear_rest(op, inside, wants(Plane::Stencil), wants(Plane::Accum));
    }
    void clear_rest(const ClearOp& op, const BlockBox& inside, bool stencil, bool accum) const {
        const Resolved& r = op.state;
        const std::uint32_t value = std::uint32_t(op.clear->stencil) & r.stencil_max;
        std::uint32_t sum[4];
        for (int c = 0; c < 4; ++c)
            sum[c] = std::uint32_t(cleared_accum(op.clear->accum[c], profile));
        for_each_block(tile, inside, [&](std::size_t b, int, int, std::uint32_t mask) {
            if (stencil) clear_stencil(r, value, tile.stencil[b], mask);
            if (accum)
                for (std::size_t c = 0; c < 4; ++c)
                    fill_lanes(tile.accum[b].channel[c], sum[c], mask);
        });
    }
    void clear_other_color(const ClearBlocks& clear) const {
        for_each_block(tile, clear.box, [&](std::size_t b, int, int, std::uint32_t mask) {
            for (std::size_t c = 0; c < 4; ++c)
                fill_bits(tile.other_color[b].channel[c], clear.color[c], clear.written_bits[c],
                          mask);
        });
    }
    static std::uint64_t pixels_in(const BlockBox& b) {
        return std::uint64_t(b.x1 - b.x0) * std::uint64_t(b.y1 - b.y0);
    }

    static void clear_stencil(const Resolved& r, std::uint32_t value, StencilBlock& block,
                              std::uint32_t mask) {
        if ((r.state.stencil.write_mask & r.stencil_max) == r.stencil_max)
            fill_lanes(block.value, value, mask);
        else
            write_stencil(r, block, mask, [&](std::size_t) { return value; });
    }
    static void fill_bits(std::uint16_t (&values)[block_pixels], std::uint16_t value,
                          std::uint16_t bits, std::uint32_t mask) {
        for (std::size_t i = 0; i < block_pixels; ++i)
            if (mask >> i & 1) values[i] = with_written_bits(values[i], value, bits);
    }
    template <typename T>
    static void fill_lanes(T (&values)[block_pixels], std::uint32_t value, std::uint32_t mask) {
        if (mask == every_lane)
            return void(std::fill_n(values, block_pixels, static_cast<T>(value)));
        for (std::size_t i = 0; i < block_pixels; ++i)
            values[i] = mask >> i & 1 ? static_cast<T>(value) : values[i];
    }
    static void write_stencil(const Resolved& r, StencilBlock& block, std::uint32_t mask,
                              const auto& value) {
        const std::uint32_t write = r.state.stencil.write_mask & r.stencil_max;
        if (write == 0) return;
        for (std::size_t i = 0; i < block_pixels; ++i)
            if (mask >> i & 1)
                block.value[i] = std::uint8_t((block.value[i] & ~write) | (value(i) & write));
    }

    void run(const SpansOp& op) {
        write_back_blocks(tile);
        DepthBlock depth;
        ColorBlock color;
        std::fill(std::begin(depth.value), std::end(depth.value), op.write->depth);
        for (const Span& span : op.write->spans) {
            const Rect rect =
                intersect({span.x, span.y, span.length, 1}, {tile.x, tile.y, tile.side, tile.side});
            if (rect.width == 0) continue;
            for_each_block(
                tile, box(intersect(rect, op.state.pixel_box)),
                [&](std::size_t b, int bx, int by, std::uint32_t mask) {
                    for_each_lane(tile, bx, by, mask, [&](std::size_t lane, int x, int) {
                        set_lane(
                            color, lane,
                            op.write
                                ->colors[span.first + (span.flat ? 0 : std::uint32_t(x - span.x))]);
                    });
                    process_fragments({&op.state, b, mask, true, sample}, color, depth, tile,
                                      *counts);
                });
        }
    }

    static void set_lane(ColorBlock& block, std::size_t lane, const Rgba& color) {
        for (std::size_t c = 0; c < 4; ++c) block.channel[c][lane] = color[c];
    }

    void run(const PixelsOp& op) {
        write_back_blocks(tile);
        const WritePixels& w = *op.write;
        const Resolved& r = op.state;
        DepthBlock depth;
        ColorBlock color;
        std::fill(std::begin(depth.value), std::end(depth.value), w.depth);
        for_each_block(
            tile, box(intersect(r.pixel_box, w.rect)),
            [&](std::size_t b, int bx, int by, std::uint32_t mask) {
                if (w.plane == Plane::Color) {
                    for_each_lane(tile, bx, by, mask, [&](std::size_t lane, int x, int y) {
                        set_lane(color, lane, w.colors[w.rect.index(x, y)]);
                    });
                    process_fragments({&r, b, mask, true, sample}, color, depth, tile, *counts);
                    return;
                }
                counts->pixels += lane_count(mask);
                for_each_lane(tile, bx, by, mask, [&](std::size_t lane, int x, int y) {
                    const std::uint32_t value = w.values[w.rect.index(x, y)];
                    if (w.plane == Plane::Depth && r.depth_mask) tile.depth[b].value[lane] = value;
                    if (w.plane == Plane::Stencil)
                        write_stencil(r, tile.stencil[b], 1u << lane,
                                      [&](std::size_t) { return value; });
                });
            });
    }

    void run(const DrawPixelsOp& op) {
        const BlockBox& inside = box(op.placed->box());
        if (inside.empty()) return;
        if (!op.placed->is_stencil())
            return draw_pixels({op.placed, &op.state, tile, inside, counts, sample});
        for_each_block(tile, inside, [&](std::size_t b, int bx, int by, std::uint32_t mask) {
            write_stencils(op, b, bx, by, mask);
        });
    }
    void write_stencils(const DrawPixelsOp& op, std::size_t b, int bx, int by,
                        std::uint32_t mask) const {
        for_each_lane(tile, bx, by, mask, [&](std::size_t lane, int x, int y) {
            const std::optional<std::size_t> pixel = op.placed->source_of(x, y);
            if (!pixel) return;
            counts->pixels += 1;
            write_stencil(op.state, tile.stencil[b], 1u << lane,
                          [&](std::size_t) { return op.placed->stencil(*pixel); });
        });
    }

    void run(const AccumulateOp& op) {
        write_back_blocks(tile);
        for_each_block(
            tile, box(op.state.pixel_box), [&](std::size_t b, int, int, std::uint32_t mask) {
                counts->pixels += lane_count(mask);
                counts->accum_overflows +=
                    accumulate_block(op, profile, tile.accum[b], tile.color[b], mask);
                if (op.accumulate->op == AccumOp::Return && draws_to_both(op.state.state))
                    accumulate_block(op, profile, tile.accum[b], tile.other_color[b], mask);
            });
    }

    void run(const ReadOp& op) {
        const BlockBox inside = box(op.read->rect);
        if (inside.empty()) return;
        counts->pixels += pixels_in(inside);
        if (op.read->plane == Plane::Color)
            return read_colors({tile, inside, op.read->rect, op.color,
                                op.read->packed ? op.values : nullptr, op.layout});
        write_back_blocks(tile);
        for_each_block(tile, inside, [&](std::size_t b, int bx, int by, std::uint32_t mask) {
            switch (op.read->plane) {
                case Plane::Color:
                case Plane::Back: return;
                case Plane::Depth:
                    return read_block(op, bx, by, mask, tile.depth[b].value, op.values);
                case Plane::Stencil:
                    return read_block(op, bx, by, mask, tile.stencil[b].value, op.values);
                case Plane::Accum:
                    return read_block(op, bx, by, mask, pixels_of(tile.accum[b]), op.accum);
            }
        });
    }
    /// Copies the lanes of `mask`, whole rows if it has all lanes.
    template <typename From, typename To>
    void read_block(const ReadOp& op, int bx, int by, std::uint32_t mask, const From& from,
                    To* to) const {
        const Rect& rect = op.read->rect;
        const auto at = [&](int x, int y) { return to + rect.index(x, y); };
        if (mask != every_lane)
            return for_each_lane(tile, bx, by, mask,
                                 [&](std::size_t lane, int x, int y) { *at(x, y) = from[lane]; });
        const int x = tile.x + bx * block_side, y = tile.y + by * block_side;
        for (int row = 0; row < block_side; ++row)
            std::copy_n(std::begin(from) + row * block_side, block_side, at(x, y + row));
    }
};

}  // namespace

TileRunner::TileRunner(int threads) {
    for (int i = 0; i < threads; ++i) scratch_.push_back(std::make_unique<TileScratch>());
}
TileRunner::~TileRunner() = default;

std::vector<OpCounts> TileRunner::run(const Segment& segment, std::span<Frame* const> frames,
                                      const Profile& profile) {
    for (auto& scratch : scratch_) {
        scratch->counts.assign(segment.count_slots.size(), {});
        scratch->records.trim(std::size_t(segment.visible_records));
    }
    parallel_for(segment.tiles.size(), int(scratch_.size()), [&](std::size_t i, int worker) {
        TileScratch& scratch = *scratch_[std::size_t(worker)];
        TileRun run{profile, frames[0]->tile(segment.tiles[i]), scratch};
        std::array<Tile, max_samples> samples;
        if (frames.size() > 1) {
            for (std::size_t k = 0; k < frames.size(); ++k)
                samples[k] = frames[k]->tile(segment.tiles[i]);
            run.samples = std::span(samples).first(frames.size());
        }
        scratch.texels.clear();
        for (std::size_t k = segment.tile_start[i]; k < segment.tile_start[i + 1]; ++k) {
            const TileOp& op = segment.ops[segment.tile_ops[k]];
            run.counts = &scratch.counts[op.count_slot];
            std::visit([&](const auto& o) { run.run_on_samples(o); }, op.op);
        }
        scratch.records.clear();
    });
    std::vector<OpCounts> totals(segment.count_slots.size());
    for (const auto& scratch : scratch_)
        for (std::size_t k = 0; k < totals.size(); ++k) totals[k] += scratch->counts[k];
    return totals;
}

}  // namespace gw::fast
