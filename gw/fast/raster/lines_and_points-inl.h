// Finds the pixels of a tile that a line or point covers, collected by block. docs/manual.md,
// "Coverage"; scalar twin: gw/reference/coverage.cpp. Does not interpolate or test. Included once
// per Highway target.
#if defined(GW_FAST_LINES_AND_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_LINES_AND_POINTS_INL_H_
#undef GW_FAST_LINES_AND_POINTS_INL_H_
#else
#define GW_FAST_LINES_AND_POINTS_INL_H_
#endif

#include "gw/fast/raster/corners-inl.h"
#include "gw/fast/raster/outer_frame.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/stages/raster/lines.h"
#include "gw/stages/stipple.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Pixels of a line or point, collected by block, then sent on in block order.
class PixelSet {
public:
    explicit PixelSet(int blocks_per_row)
        : row_shift_(std::countr_zero(unsigned(blocks_per_row))) {}

    void add(int x, int y) {
        const auto block = std::size_t(((y / block_side) << row_shift_) + x / block_side);
        std::uint64_t& word = used_[block / 64];
        const std::uint64_t bit = std::uint64_t{1} << block % 64;
        const unsigned before = word & bit ? mask_[block] : 0u;
        word |= bit;
        mask_[block] = std::uint16_t(before | 1u << (y % block_side * block_side + x % block_side));
    }
    /// Calls visit(bx, by, lanes) for each block that has pixels.
    template <class Visit>
    void visit(const Visit& visit) const {
        for (int i = 0; i < 4; ++i)
            for (std::uint64_t rest = used_[i]; rest != 0; rest &= rest - 1) {
                const int block = 64 * i + std::countr_zero(rest);
                visit(block & ((1 << row_shift_) - 1), block >> row_shift_, lane_set(mask_[block]));
            }
    }

private:
    int row_shift_;                        ///< blocks of a row are a power of two
    std::uint64_t used_[4] = {};           ///< a bit for each block
    std::uint16_t mask_[max_tile_blocks];  ///< of the blocks that are used
};

/// floor(n / d) and the rest, which is not negative.
struct Floor {
    std::int64_t whole, rest;
    Floor(std::int64_t n, std::int64_t d) : whole(n / d), rest(n % d) {
        if (rest < 0) --whole, rest += d;
    }
};

/// Rows from floor((v(p) - (width - 1) 2^(s-1)) / 2^s) in each column of the line; those of its outer
/// column apart.
inline void line_pixels(const TileDraw& draw, const PrimitiveFrame& f, const LineRule& rule,
                        PixelSet& inner, PixelSet& outer) {
    const int s = f.s;
    const auto& u = f.x_major ? f.x : f.y;
    const auto& v = f.x_major ? f.y : f.x;
    const int u_tile = f.x_major ? draw.tile.x : draw.tile.y,
              v_tile = f.x_major ? draw.tile.y : draw.tile.x;
    const BlockBox& b = draw.box;
    const int v0 = f.x_major ? b.y0 : b.x0, v1 = f.x_major ? b.y1 : b.x1;
    const std::int64_t du = u[1] - u[0], dv = v[1] - v[0], row = f.length << s;
    const LineEnds ends{{f.x[0], f.x[1]}, {f.y[0], f.y[1]}};
    const LineSteps steps = line_steps(ends, rule);
    const auto begin = std::max<std::int64_t>(steps.low() - u_tile, f.x_major ? b.x0 : b.y0),
               end = std::min<std::int64_t>(steps.high() - u_tile, f.x_major ? b.x1 : b.y1);
    if (begin >= end) return;
    const LineStippleState& stipple = draw.op->state.state.line_stipple;
    const std::int64_t slope = du > 0 ? dv : -dv;
    const std::int64_t p = ((u_tile + begin) << s) + (std::int64_t{1} << (s - 1));
    const std::int64_t below = (rule.width - 1) * row / 2 + boundary_step(ends, rule);
    Floor top(v[0] * f.length + slope * (p - u[0]) - below, row);
    const Floor step(slope << s, row);
    for (int i = int(begin); i < int(end); ++i) {
        const std::int64_t first = top.whole - v_tile;
        top.whole += step.whole;
        top.rest += step.rest;
        if (top.rest >= row) ++top.whole, top.rest -= row;
        if (stipple.enable &&
            !stipple_bit(stipple, f.stippled + std::uint64_t(steps.step_of(u_tile + i))))
            continue;
        PixelSet& out = steps.outer_first && u_tile + i == steps.first ? outer : inner;
        for (std::int64_t j = std::max<std::int64_t>(first, v0);
             j < std::min<std::int64_t>(first + rule.width, v1); ++j)
            f.x_major ? out.add(i, int(j)) : out.add(int(j), i);
    }
}

inline void point_pixels(const TileDraw& draw, const PrimitiveFrame& f, int size, PixelSet& out) {
    const std::int64_t shift = (size - 1) * (std::int64_t{1} << (f.s - 1));
    const std::int64_t x = ((f.x[0] - shift) >> f.s) - draw.tile.x,
                       y = ((f.y[0] - shift) >> f.s) - draw.tile.y;
    const BlockBox& b = draw.box;
    for (std::int64_t j = std::max<std::int64_t>(y, b.y0);
         j < std::min<std::int64_t>(y + size, b.y1); ++j)
        for (std::int64_t i = std::max<std::int64_t>(x, b.x0);
             i < std::min<std::int64_t>(x + size, b.x1); ++i)
            out.add(int(i), int(j));
}

/// Calls visit(bx, by, lanes) for the pixels whose centre is no outer one, then
/// visit_outer(frame, bx, by, lane) for each other pixel, with its frame.
template <class Visit, class VisitOuter>
inline void visit_line_or_point(const TileDraw& draw, const PrimitiveFrame& frame,
                                const Visit& visit, const VisitOuter& visit_outer) {
    PixelSet inner(draw.tile.side / block_side), outer(draw.tile.side / block_side);
    const State& s = draw.op->state.state;
    if (frame.kind == MeshKind::Lines)
        line_pixels(draw, frame, line_rule(s, frame.s), inner, outer);
    else
        point_pixels(draw, frame, whole_size(frame.point_size), inner);
    inner.visit(visit);
    outer.visit([&](int bx, int by, const LaneSet& lanes) {
        for (std::uint32_t rest = lanes.bits(); rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            visit_outer(outer_frame(draw, frame, bx, by, lane), bx, by, lane);
        }
    });
}
/// Of lines and points without outer pixels.
template <class Visit>
inline void visit_line_or_point(const TileDraw& draw, const PrimitiveFrame& frame,
                                const Visit& visit) {
    visit_line_or_point(draw, frame, visit, [](const PrimitiveFrame&, int, int, int) {});
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
