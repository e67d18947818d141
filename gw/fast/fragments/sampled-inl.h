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
#include "gw/fast/fragments/outer_pixels-inl.h"
#include "gw/fast/fragments/smooth_painter-inl.h"
#include "gw/fast/raster/lines_and_points-inl.h"
#include "gw/fast/raster/sampled_triangles-inl.h"
#include "gw/stages/raster/samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

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
                   const SampleRules& rules, OpCounts& counts,
                   const SampledTriangles* triangles = nullptr)
        : planes_(planes),
          draw_(planes.draw),
          i_(i),
          ordinal_(ordinal),
          primitive_(*planes.corners.primitive[i]),
          rules_(rules),
          counts_(counts) {
        if (!needs_depth(*draw_.op)) return;
        for (int k = 0; k < rules.samples; ++k) {
            const PlaneBatch* const depth =
                triangles ? &triangles->at[std::size_t(k)].depth : nullptr;
            depths_[std::size_t(k)] = depth && (depth->sure >> i & 1) != 0
                                          ? DepthPlane{depth->at(i), 0}
                                          : depth_plane(draw_, primitive_, at(k));
        }
    }
    const PrimitiveFrame& center() {
        if (!center_) center_ = frame_of(draw_, ordinal_);
        return *center_;
    }
    PrimitiveFrame at(int k) const { return sample_frame(draw_, primitive_, rules_.samples, k); }

    /// `inside`: lanes whose centres are covered.
    HWY_NOINLINE void paint(int bx, int by, const SampleLanes& covered, std::uint32_t inside) {
        std::uint32_t any = 0;
        for (int k = 0; k < rules_.samples; ++k) any |= covered[std::size_t(k)];
        if (any == 0) return;
        is_shaded_ = false;
        const auto color = [&]() -> const ColorBlock& {
            if (!is_shaded_) shade(bx, by, covered, any, inside);
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
    HWY_NOINLINE void shade(int bx, int by, const SampleLanes& covered, std::uint32_t any,
                            std::uint32_t inside) {
        is_shaded_ = true;
        const std::uint32_t inner = any & inside, outer = any & ~inside;
        if (outer == 0) {
            color_ = planes_.color_of(i_, bx, by, inner);
        } else if (makes_outer()) {
            outer_->places.aim(covered, outer);
            color_ = outer_->color_of(planes_, i_, bx, by, inner, outer);
        } else {
            if (inner != 0) color_ = planes_.color_of(i_, bx, by, inner);
            shade_each(bx, by, covered, outer);
        }
        if (rules_.by_alpha)
            for (int k = 0; k < rules_.samples; ++k)
                kept_by_alpha_[std::size_t(k)] = rules_.kept(k, color_, all_lanes);
        if (rules_.to_one)
            std::fill(std::begin(color_.channel[3]), std::end(color_.channel[3]), rules_.one);
    }

    HWY_INLINE bool makes_outer() {
        if (!outer_ && OuterPixels<FirstSamples>::applies_to(planes_, i_))
            outer_.emplace(planes_, i_, ordinal_);
        return outer_.has_value();
    }

    /// The colours of lanes with outer centres, one by one.
    HWY_NOINLINE void shade_each(int bx, int by, const SampleLanes& covered, std::uint32_t lanes) {
        FirstSamples places(planes_, i_);
        places.aim(covered, lanes);
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            const PrimitiveFrame at = places.frame(center(), bx, by, lane);
            copy_lane(outer_color(draw_, primitive_, at, bx, by, 1u << lane, outer_inputs_), lane,
                      color_);
        }
    }

    BatchPlanes& planes_;
    const TileDraw& draw_;
    std::size_t i_;
    std::uint32_t ordinal_;
    const SetupPrimitive& primitive_;
    const SampleRules& rules_;
    OpCounts& counts_;
    std::optional<PrimitiveFrame> center_;
    std::array<DepthPlane, max_samples> depths_;
    bool is_shaded_ = false;
    ColorBlock color_;
    SampleLanes kept_by_alpha_{};
    ShadeInputs outer_inputs_;
    std::optional<OuterPixels<FirstSamples>> outer_;
};

/// The lanes of a block that the box and the stipple leave.
HWY_INLINE std::uint32_t drawn_lanes(const TileDraw& draw, int bx, int by) {
    return stippled(draw, bx, by, lane_set(draw.box.mask(bx, by))).bits();
}

/// Triangle i, which touches at most 2x2 blocks with any sample: at most 3x3 with all.
HWY_NOINLINE inline void draw_small_sampled(const TileDraw& draw, SampledPainter& painter,
                                            const SampledTriangles& triangles, std::size_t i,
                                            const BlockRange& range) {
    constexpr int side = 3;
    std::array<SampleLanes, side * side> covered{};
    std::array<std::uint32_t, side * side> inside{};
    const auto each_block = [&](const Triangles& t, const auto& put) {
        const int x = t.x0[i] / block_side - range.x0, y = t.y0[i] / block_side - range.y0;
        for (int k = 0; k < 4; ++k) {
            const auto lanes = std::uint32_t(t.small_lanes(i) >> (k * block_pixels)) & all_lanes;
            const int bx = x + k % 2, by = y + k / 2;
            if (lanes != 0 && bx >= 0 && by >= 0 && bx < side && by < side)
                put(std::size_t(side * by + bx), lanes);
        }
    };
    triangles.for_each_of(i, [&](int k, const Triangles& t) {
        each_block(t, [&](std::size_t block, std::uint32_t lanes) {
            covered[block][std::size_t(k)] = lanes;
        });
    });
    if (!triangles.center.empty(i))
        each_block(triangles.center,
                   [&](std::size_t block, std::uint32_t lanes) { inside[block] = lanes; });
    for (int by = range.y0; by <= range.y1; ++by)
        for (int bx = range.x0; bx <= range.x1; ++bx) {
            const std::size_t block = std::size_t(side * (by - range.y0) + bx - range.x0);
            const std::uint32_t drawn = drawn_lanes(draw, bx, by);
            for (std::uint32_t& lanes : covered[block]) lanes &= drawn;
            painter.paint(bx, by, covered[block], inside[block]);
        }
}

HWY_NOINLINE inline void draw_large_sampled(const TileDraw& draw, SampledPainter& painter,
                                            const SampledTriangles& triangles, std::size_t i,
                                            const BlockRange& range) {
    SampledGroup center;
    std::array<SampledGroup, max_samples> at;
    const int samples = triangles.samples;
    const auto first = [](int block) { return block - block % group_blocks; };
    for (int y = first(range.y0); y <= range.y1; y += group_blocks)
        for (int x = first(range.x0); x <= range.x1; x += group_blocks) {
            std::uint32_t outside = all_lanes;
            for (int k = 0; k < samples; ++k) {
                SampledGroup& group = at[std::size_t(k)];
                group.find(triangles.at[std::size_t(k)].edges(i), x, y);
                outside &= group.extents.outside;
            }
            std::uint32_t rest = range.squares(x, y, 1) & ~outside;
            if (rest != 0) center.find(triangles.center.edges(i), x, y);
            for (; rest != 0; rest &= rest - 1) {
                const int block = std::countr_zero(rest), bx = x + block % group_blocks,
                          by = y + block / group_blocks;
                const std::uint32_t drawn = drawn_lanes(draw, bx, by);
                SampleLanes covered{};
                for (int k = 0; k < samples; ++k)
                    covered[std::size_t(k)] = at[std::size_t(k)].covered(block) & drawn;
                painter.paint(bx, by, covered, center.covered(block));
            }
        }
}

/// Lanes of a tile's blocks, by sample and at the centres.
class SampledBlocks {
public:
    explicit SampledBlocks(const Tile& tile) : columns_(tile.side / block_side) {}
    void add(int k, int bx, int by, std::uint32_t lanes) {
        lanes_[std::size_t(by * columns_ + bx)][std::size_t(k)] |= lanes;
    }
    void add_center(int bx, int by, std::uint32_t lanes) {
        centers_[std::size_t(by * columns_ + bx)] |= lanes;
    }
    void visit(const auto& visit) const {
        for (int i = 0; i < columns_ * columns_; ++i)
            visit(i % columns_, i / columns_, lanes_[std::size_t(i)], centers_[std::size_t(i)]);
    }

private:
    int columns_;
    std::array<SampleLanes, max_tile_blocks> lanes_{};
    std::array<std::uint32_t, max_tile_blocks> centers_{};
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
    visit_line_or_point(draw, painter.center(), [&](int bx, int by, const LaneSet& lanes) {
        blocks.add_center(bx, by, lanes.bits());
    });
    blocks.visit([&](int bx, int by, const SampleLanes& covered, std::uint32_t centers) {
        painter.paint(bx, by, covered, centers);
    });
}

HWY_NOINLINE inline void draw_sampled_batch(const TileDraw& draw,
                                            std::span<const std::uint32_t> batch,
                                            const SampleRules& rules, OpCounts& counts) {
    const SampledTriangles triangles(draw, batch, rules.samples);
    BatchPlanes planes(draw, triangles.center.corners);
    for (std::size_t i = 0; i < triangles.center.count(); ++i) {
        const BlockRange range = triangles.range(i);
        if (range.x0 > range.x1) continue;
        SampledPainter painter(planes, i, batch[i], rules, counts, &triangles);
        if (triangles.is_small(i))
            draw_small_sampled(draw, painter, triangles, i, range);
        else
            draw_large_sampled(draw, painter, triangles, i, range);
    }
}

/// Draws the primitives of a bin to all samples of a tile. No block of them is uniform.
HWY_NOINLINE inline void draw_sampled(const TileDraw& draw, std::span<const std::uint32_t> bin) {
    OpCounts counts;
    const SampleRules rules(draw.op->state);
    walk_bin(
        draw, bin,
        [&](std::span<const std::uint32_t> batch) {
            draw_sampled_batch(draw, batch, rules, counts);
        },
        [&](std::span<const std::uint32_t> batch) {
            for (const std::uint32_t ordinal : batch)
                draw_sampled_line_or_point(draw, ordinal, rules, counts);
        });
    *draw.counts += counts;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
