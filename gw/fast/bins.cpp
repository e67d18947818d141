// Which primitives touch which tile: a counting sort that keeps their order.
#include "gw/fast/geometry.h"

#include <algorithm>

namespace gw::fast {
namespace {

/// Tiles [x0, x1) x [y0, y1) that a primitive may touch.
struct TileRange {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct Binner {
    const GeometrySet& set;
    int s;
    const TileGrid& grid;

    /// Pixels whose centre lies in [low, high] (in sub-pixels), widened by `margin` pixels: first and one
    /// past the last.
    std::pair<int, int> pixels(std::int64_t low, std::int64_t high, int margin) const {
        const std::int64_t half = std::int64_t{1} << (s - 1);
        return {int((low + half - 1) >> s) - margin, int((high - half) >> s) + 1 + margin};
    }

    TileRange tiles(const SetupPrimitive& p) const {
        const auto [a, b, c] = p.vertex;
        const auto [x_low, x_high] = std::minmax({set.x[a], set.x[b], set.x[c]});
        const auto [y_low, y_high] = std::minmax({set.y[a], set.y[b], set.y[c]});
        const int margin = p.kind == MeshKind::Lines    ? set.key.line_width
                           : p.kind == MeshKind::Points ? set.key.point_size
                                                        : 0;
        const auto [px0, px1] =
            pixels(std::int64_t{x_low} + set.jitter_low.x, std::int64_t{x_high} + set.jitter_high.x, margin);
        const auto [py0, py1] =
            pixels(std::int64_t{y_low} + set.jitter_low.y, std::int64_t{y_high} + set.jitter_high.y, margin);
        const int x0 = std::max(px0, 0), y0 = std::max(py0, 0);
        const int x1 = std::min(px1, grid.width), y1 = std::min(py1, grid.height);
        if (x0 >= x1 || y0 >= y1) return {};
        const int mask = grid.side() - 1, log2 = grid.log2_tile;
        return {x0 >> log2, y0 >> log2, (x1 + mask) >> log2, (y1 + mask) >> log2};
    }

    template <typename Visit>
    void for_each_pair(const Visit& visit) const {
        for (std::uint32_t i = 0; i < set.primitives.size(); ++i) {
            const TileRange r = tiles(set.primitives[i]);
            for (int y = r.y0; y < r.y1; ++y)
                for (int x = r.x0; x < r.x1; ++x)
                    visit(std::size_t(y) * std::size_t(grid.columns()) + std::size_t(x), i);
        }
    }
};

}  // namespace

void make_bins(GeometrySet& set, const Profile& profile, const TileGrid& grid) {
    const Binner binner{set, profile.subpixel_bits, grid};
    std::vector<std::uint32_t> start(grid.count() + 1);
    binner.for_each_pair([&](std::size_t tile, std::uint32_t) { start[tile + 1] += 1; });
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    std::vector<std::uint32_t> bin(start.back());
    binner.for_each_pair([&](std::size_t tile, std::uint32_t i) { bin[next[tile]++] = i; });
    set.bin_start = std::move(start);
    set.bin = std::move(bin);
}

}  // namespace gw::fast
