// Fragments on surfaces with samples: coverage, depth and the tests at each sample of a block, one
// colour for all of them. docs/manual/samples.md; scalar twins: gw/reference/primitives.cpp,
// gw/reference/fragment.cpp. Included once per Highway target.
#if defined(GW_FAST_SAMPLED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SAMPLED_INL_H_
#undef GW_FAST_SAMPLED_INL_H_
#else
#define GW_FAST_SAMPLED_INL_H_
#endif

#include "gw/fast/fragments/antialiased-inl.h"
#include "gw/fast/fragments/fragments-inl.h"
#include "gw/fast/fragments/smooth_painter-inl.h"
#include "gw/fast/raster/cover-inl.h"
#include "gw/fast/raster/lines_and_points-inl.h"
#include "gw/stages/raster/samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Lanes of a block, by sample.
using SampleLanes = std::array<std::uint32_t, max_samples>;

/// What alpha and the coverage test leave of a fragment's samples.
struct SampleRules {
    int samples;
    SampleMask tested;
    bool by_alpha, to_one;
    std::array<std::uint32_t, max_samples> least_alpha{};
    std::uint16_t one;

    explicit SampleRules(const Resolved& r)
        : samples(r.samples),
          tested(tested_samples(r)),
          by_alpha(r.state.multisample.alpha_to_coverage),
          to_one(r.state.multisample.alpha_to_one),
          one(std::uint16_t(max_of_bits(r.bits))) {
        for (int k = 0; k < samples; ++k)
            least_alpha[std::size_t(k)] = gw::least_alpha(samples, k, r.bits);
    }
    /// Whether the colour has a part in them, or is changed.
    bool need_color() const { return by_alpha || to_one; }
    bool keep(int k) const { return (tested >> k & 1) != 0; }
    /// The lanes of `mask` that keep sample k.
    std::uint32_t kept(int k, const ColorBlock& color, std::uint32_t mask) const {
        if (!keep(k)) return 0;
        if (!by_alpha) return mask;
        std::uint32_t lanes = 0;
        for (std::size_t i = 0; i < block_pixels; ++i)
            lanes |= std::uint32_t(color.channel[3][i] >= least_alpha[std::size_t(k)]) << i;
        return lanes & mask;
    }
};

/// Fragments of the host at one sample: they cover all samples.
HWY_NOINLINE inline void run_sample(const Resolved& r, int sample, bool front,
                                    const DepthBlock& depth, const Tile& tile, std::size_t block,
                                    std::uint32_t mask, OpCounts& counts, const ColorBlock& color) {
    const SampleRules rules(r);
    const std::uint32_t kept = rules.kept(sample, color, mask);
    ColorBlock used = color;
    if (rules.to_one) std::fill(std::begin(used.channel[3]), std::end(used.channel[3]), rules.one);
    OpCounts own;
    if (kept != 0)
        run_fragments(r, front, depth, tile, block, kept, own,
                      [&]() -> const ColorBlock& { return used; });
    own.fragments = std::uint64_t(std::popcount(mask));
    counts += own;
}

/// Primitive i of a batch on the samples of a tile.
class SampledPainter {
public:
    SampledPainter(BatchPlanes& planes, std::size_t i, std::uint32_t ordinal,
                   const SampleRules& rules, OpCounts& counts)
        : planes_(planes),
          draw_(planes.draw),
          i_(i),
          primitive_(*planes.corners.primitive[i]),
          rules_(rules),
          counts_(counts),
          center_(frame_of(draw_, ordinal)) {
        for (int k = 0; k < rules.samples; ++k) {
            PrimitiveFrame& frame = frames_[std::size_t(k)];
            const JitterState shift = sample_shift(rules.samples, k, draw_.profile->subpixel_bits),
                              &jitter = draw_.op->state.state.jitter;
            frame = primitive_frame(*draw_.op->set, primitive_,
                                    {jitter.x + shift.x, jitter.y + shift.y},
                                    draw_.profile->subpixel_bits, draw_.tile);
            frame.point_size = center_.point_size;
            if (needs_depth(*draw_.op))
                depths_[std::size_t(k)] = depth_plane(draw_, primitive_, frame);
        }
    }
    const PrimitiveFrame& center() const { return center_; }
    const PrimitiveFrame& at(int k) const { return frames_[std::size_t(k)]; }

    /// `inside`: lanes with no outer centre.
    HWY_NOINLINE void paint(int bx, int by, const SampleLanes& covered, std::uint32_t inside) {
        std::uint32_t any = 0;
        for (int k = 0; k < rules_.samples; ++k) any |= covered[std::size_t(k)];
        if (any == 0) return;
        is_shaded_ = false;
        const auto color = [&]() -> const ColorBlock& {
            if (!is_shaded_) shade(bx, by, any, inside);
            return color_;
        };
        OpCounts own;
        if (draw_.op->needs_color && rules_.by_alpha) color();
        for (int k = 0; k < rules_.samples; ++k) {
            const std::uint32_t mask = kept(k, covered[std::size_t(k)]);
            if (mask == 0) continue;
            DepthBlock depth;
            if (needs_depth(*draw_.op))
                shade_depth(depths_[std::size_t(k)], max_of_bits(draw_.profile->depth_bits), bx, by,
                            depth);
            const Tile& tile = draw_.samples[std::size_t(k)];
            run_fragments(draw_.op->state, primitive_.front != 0, depth, tile, tile.block(bx, by),
                          mask, own, color);
        }
        own.fragments = std::uint64_t(std::popcount(any));
        counts_ += own;
    }

private:
    std::uint32_t kept(int k, std::uint32_t mask) const {
        if (rules_.by_alpha) return mask & kept_by_alpha_[std::size_t(k)];
        return rules_.keep(k) ? mask : 0;
    }
    HWY_NOINLINE void shade(int bx, int by, std::uint32_t any, std::uint32_t inside) {
        is_shaded_ = true;
        if ((any & inside) != 0) color_ = planes_.color_of(i_, bx, by, any & inside);
        for (std::uint32_t outside = any & ~inside; outside != 0; outside &= outside - 1) {
            const int lane = std::countr_zero(outside);
            if (has_outer_colors_) {
                shade_outer(outer_frame(draw_, center_, bx, by, lane), lane);
                continue;
            }
            const ColorBlock& outer =
                outer_color(draw_, primitive_, outer_frame(draw_, center_, bx, by, lane), bx, by,
                            1u << lane, outer_);
            for (std::size_t c = 0; c < 4; ++c) color_.channel[c][lane] = outer.channel[c][lane];
        }
        if (rules_.by_alpha)
            for (int k = 0; k < rules_.samples; ++k)
                kept_by_alpha_[std::size_t(k)] = rules_.kept(k, color_, all_lanes);
        if (rules_.to_one)
            std::fill(std::begin(color_.channel[3]), std::end(color_.channel[3]), rules_.one);
    }

    void shade_outer(const PrimitiveFrame& at, int lane) {
        if (!outer_colors_) outer_colors_.emplace(draw_, primitive_, center_);
        const Rgba color = outer_colors_->at(at.pixel_x, at.pixel_y);
        for (std::size_t c = 0; c < 4; ++c) color_.channel[c][lane] = color[c];
    }

    BatchPlanes& planes_;
    const TileDraw& draw_;
    std::size_t i_;
    const SetupPrimitive& primitive_;
    const SampleRules& rules_;
    OpCounts& counts_;
    const PrimitiveFrame center_;
    std::array<PrimitiveFrame, max_samples> frames_;
    std::array<DepthPlane, max_samples> depths_;
    bool is_shaded_ = false;
    ColorBlock color_{};
    SampleLanes kept_by_alpha_{};
    ShadeInputs outer_;
    const bool has_outer_colors_ = OuterColors::applies_to(*draw_.op);
    std::optional<OuterColors> outer_colors_;
};

/// The blocks that a triangle may touch with a sample: its centres reach half a pixel further.
inline BlockBox sampled_box(const TileDraw& draw, const PrimitiveFrame& f) {
    const auto [x0, x1] = std::minmax_element(f.x.begin(), f.x.end());
    const auto [y0, y1] = std::minmax_element(f.y.begin(), f.y.end());
    const auto low = [&](std::int64_t v) { return (v >> f.s) - 1; };
    BlockBox box = draw.box;
    box.x0 = int(std::max<std::int64_t>(box.x0, low(*x0) - draw.tile.x));
    box.y0 = int(std::max<std::int64_t>(box.y0, low(*y0) - draw.tile.y));
    box.x1 = int(std::min<std::int64_t>(box.x1, low(*x1) + 3 - draw.tile.x));
    box.y1 = int(std::min<std::int64_t>(box.y1, low(*y1) + 3 - draw.tile.y));
    return box;
}

HWY_NOINLINE inline void draw_sampled_triangle(const TileDraw& draw, SampledPainter& painter,
                                               const SampleRules& rules) {
    const BlockBox box = sampled_box(draw, painter.center());
    if (box.empty()) return;
    std::array<EdgeWalk, max_samples> walks;
    EdgeWalk center;
    const int bx0 = box.x0 / block_side, by0 = box.y0 / block_side;
    const auto aim = [&](EdgeWalk& walk, const PrimitiveFrame& frame) {
        walk.aim(tile_edges(frame, draw.tile));
        walk.start_rows(bx0, by0);
    };
    aim(center, painter.center());
    for (int k = 0; k < rules.samples; ++k) aim(walks[std::size_t(k)], painter.at(k));
    const auto each = [&](const auto& move) {
        move(center);
        for (int k = 0; k < rules.samples; ++k) move(walks[std::size_t(k)]);
    };
    for (int by = by0; by * block_side < box.y1; ++by) {
        for (int bx = bx0; bx * block_side < box.x1; ++bx) {
            const std::uint32_t drawn =
                stippled(draw, bx, by, lane_set(draw.box.mask(bx, by))).bits();
            SampleLanes covered{};
            for (int k = 0; k < rules.samples; ++k)
                covered[std::size_t(k)] = walks[std::size_t(k)].covered().bits() & drawn;
            painter.paint(bx, by, covered, center.covered().bits());
            each([](EdgeWalk& walk) { walk.next_block(); });
        }
        each([](EdgeWalk& walk) { walk.next_row(); });
    }
}

/// Lanes of a tile's blocks, by sample.
class SampledBlocks {
public:
    explicit SampledBlocks(const Tile& tile) : columns_(tile.side / block_side) {}
    void add(int k, int bx, int by, std::uint32_t lanes) {
        lanes_[std::size_t(by * columns_ + bx)][std::size_t(k)] |= lanes;
    }
    void visit(const auto& visit) const {
        for (int i = 0; i < columns_ * columns_; ++i)
            visit(i % columns_, i / columns_, lanes_[std::size_t(i)]);
    }

private:
    int columns_;
    std::array<SampleLanes, max_tile_blocks> lanes_{};
};

HWY_NOINLINE inline void draw_sampled_line_or_point(const TileDraw& draw, std::uint32_t ordinal,
                                                    const SampleRules& rules, OpCounts& counts) {
    Corners corners;
    gather_corners(draw, {&ordinal, 1}, corners);
    BatchPlanes planes(draw, corners);
    SampledPainter painter(planes, 0, ordinal, rules, counts);
    SampledBlocks blocks(draw.tile);
    for (int k = 0; k < rules.samples; ++k)
        visit_line_or_point(draw, painter.at(k), [&](int bx, int by, const LaneSet& lanes) {
            blocks.add(k, bx, by, lanes.bits());
        });
    const PrimitiveFrame& center = painter.center();
    // A point has one value everywhere, unless it is a sprite.
    const bool is_line = center.kind == MeshKind::Lines;
    const BlockBox inner = is_line ? between_ends(draw, center) : BlockBox{};
    const std::uint32_t of_point = draw.op->state.state.point_sprite ? 0 : all_lanes;
    blocks.visit([&](int bx, int by, const SampleLanes& covered) {
        painter.paint(bx, by, covered, is_line ? inner.mask(bx, by) : of_point);
    });
}

/// Draws the primitives of a bin to all samples of a tile. No block of them is uniform.
HWY_NOINLINE inline void draw_sampled(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    OpCounts counts;
    const SampleRules rules(draw.op->state);
    walk_bin(
        draw, bin,
        [&](std::span<const std::uint32_t> batch) {
            Corners corners;
            gather_corners(draw, batch, corners);
            BatchPlanes planes(draw, corners);
            for (std::size_t i = 0; i < corners.count; ++i) {
                SampledPainter painter(planes, i, batch[i], rules, counts);
                draw_sampled_triangle(draw, painter, rules);
            }
        },
        [&](std::uint32_t ordinal) { draw_sampled_line_or_point(draw, ordinal, rules, counts); });
    *draw.counts += counts;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
