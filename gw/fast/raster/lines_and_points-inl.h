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
#include "gw/fast/simd/walk-inl.h"
#include "gw/stages/stipple.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

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
    const int u_tile = f.x_major ? draw.tile.x : draw.tile.y,
              v_tile = f.x_major ? draw.tile.y : draw.tile.x;
    const BlockBox& b = draw.box;
    const int u0 = f.x_major ? b.x0 : b.y0, u1 = f.x_major ? b.x1 : b.y1,
              v0 = f.x_major ? b.y0 : b.x0, v1 = f.x_major ? b.y1 : b.x1;
    const std::int64_t du = u[1] - u[0], dv = v[1] - v[0], row = f.length << s;
    const LineStippleState& stipple = draw.op->state.state.line_stipple;
    const LineSteps steps = line_steps(u[0], u[1], s);
    for (int i = u0; i < u1; ++i) {
        const std::int64_t p = (std::int64_t{u_tile + i} << s) + (std::int64_t{1} << (s - 1));
        if (du > 0 ? p < u[0] || p >= u[1] : p > u[0] || p <= u[1]) continue;
        if (stipple.enable &&
            !stipple_bit(stipple, f.stippled + std::uint64_t(steps.step_of(u_tile + i))))
            continue;
        const std::int64_t top =
            v[0] * f.length + (du > 0 ? dv : -dv) * (p - u[0]) - (width - 1) * row / 2;
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
    for (std::int64_t j = std::max<std::int64_t>(y, b.y0);
         j < std::min<std::int64_t>(y + size, b.y1); ++j)
        for (std::int64_t i = std::max<std::int64_t>(x, b.x0);
             i < std::min<std::int64_t>(x + size, b.x1); ++i)
            out.add(int(i), int(j));
}

template <class Visit>
inline void visit_line_or_point(const TileDraw& draw, const PrimitiveFrame& frame,
                                const Visit& visit) {
    PixelSet pixels;
    pixels.blocks_per_row = draw.tile.side / block_side;
    const State& s = draw.op->state.state;
    if (frame.kind == MeshKind::Lines)
        line_pixels(draw, frame, whole_size(s.line_width), pixels);
    else
        point_pixels(draw, frame, whole_size(s.point_size), pixels);
    for (int block = 0; block < pixels.blocks_per_row * pixels.blocks_per_row; ++block)
        if (pixels.mask[block] != 0)
            visit(block % pixels.blocks_per_row, block / pixels.blocks_per_row,
                  lane_set(pixels.mask[block]));
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
