// Which primitives touch which tile: a counting sort that keeps their order.
#include "gw/fast/frame/frame.h"
#include "gw/fast/vertices/geometry.h"
#include "gw/profile.h"

#include <algorithm>
#include <array>

namespace gw::fast {
namespace {

/// Tiles [x0, x1) x [y0, y1) that a primitive may touch.
struct TileRange {
    std::uint16_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Along one axis: pixels whose centres lie in [low, high] (in sub-pixels), widened by `margin`
/// pixels, as tiles.
struct Axis {
    int s, log2_tile, size, jitter_low, jitter_high;

    std::array<std::uint16_t, 2> tiles(std::int32_t a, std::int32_t b, std::int32_t c,
                                       int margin) const {
        const std::int32_t half = 1 << (s - 1), mask = (1 << log2_tile) - 1;
        const std::int32_t low = std::min(std::min(a, b), c) + jitter_low,
                           high = std::max(std::max(a, b), c) + jitter_high;
        const std::int32_t first = std::max(((low + half - 1) >> s) - margin, 0),
                           end = std::min(((high - half) >> s) + 1 + margin, size);
        if (first >= end) return {0, 0};
        return {std::uint16_t(first >> log2_tile), std::uint16_t((end + mask) >> log2_tile)};
    }
};

struct Binner {
    const GeometrySet& set;
    Axis x, y;
    std::size_t columns;

    TileRange tiles(const SetupPrimitive& p) const {
        const auto [a, b, c] = p.vertex;
        const int margin = p.kind == MeshKind::Lines    ? set.key.line_width
                           : p.kind == MeshKind::Points ? set.key.point_size
                                                        : 0;
        const SnappedVertex &va = set.at[a], &vb = set.at[b], &vc = set.at[c];
        const auto [x0, x1] = x.tiles(va.x, vb.x, vc.x, margin);
        const auto [y0, y1] = y.tiles(va.y, vb.y, vc.y, margin);
        return {x0, y0, x1, y1};
    }
    std::vector<TileRange> ranges() const {
        std::vector<TileRange> out(set.primitives.size());
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = tiles(set.primitives[i]);
        return out;
    }
    void for_each_tile(const TileRange& r, const auto& visit) const {
        for (std::size_t row = r.y0; row < r.y1; ++row)
            for (std::size_t column = r.x0; column < r.x1; ++column) visit(row * columns + column);
    }
};

}  // namespace

void make_bins(GeometrySet& set, const Profile& profile, const TileGrid& grid) {
    if (!set.bin_start.empty() && set.binned.covers(set.jitter)) return;
    set.binned = set.jitter;
    const auto axis = [&](int size, int low, int high) {
        return Axis{profile.subpixel_bits, grid.log2_tile, size, low, high};
    };
    const Binner binner{set, axis(grid.width, set.jitter.low.x, set.jitter.high.x),
                        axis(grid.height, set.jitter.low.y, set.jitter.high.y),
                        std::size_t(grid.columns())};
    const std::vector<TileRange> ranges = binner.ranges();
    std::vector<std::uint32_t> start(grid.count() + 1);
    for (const TileRange& r : ranges)
        binner.for_each_tile(r, [&](std::size_t tile) { start[tile + 1] += 1; });
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    std::vector<std::uint32_t> bin(start.back());
    for (std::uint32_t i = 0; i < ranges.size(); ++i)
        binner.for_each_tile(ranges[i], [&](std::size_t tile) { bin[next[tile]++] = i; });
    set.bin_start = std::move(start);
    set.bin = std::move(bin);
}

}  // namespace gw::fast
