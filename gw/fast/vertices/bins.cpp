// Sorts primitives into the tiles that they touch: a counting sort that keeps their order.
#include "gw/fast/frame/frame.h"
#include "gw/fast/vertices/geometry_scratch.h"
#include "gw/profile.h"

#include <algorithm>
#include <array>

namespace gw::fast {
namespace {

/// The tiles along one axis with pixels whose centres lie in [low, high] (in sub-pixels), widened
/// by `margin` pixels.
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

    TileRange tiles(const SetupPrimitive& p) const {
        const auto [a, b, c] = p.vertex;
        const int margin = p.kind == MeshKind::Lines    ? set.state.line_margin
                           : p.kind == MeshKind::Points ? set.state.point_margin
                                                        : set.state.fill_margin;
        const SnappedVertex &va = set.at[a], &vb = set.at[b], &vc = set.at[c];
        const auto [x0, x1] = x.tiles(va.x, vb.x, vc.x, margin);
        const auto [y0, y1] = y.tiles(va.y, vb.y, vc.y, margin);
        return {x0, y0, x1, y1};
    }
    /// Calls add(column, row) for each tile of a primitive.
    static void for_each_tile(const TileRange& r, const auto& add) {
        for (std::uint16_t row = r.y0; row < r.y1; ++row)
            for (std::uint16_t column = r.x0; column < r.x1; ++column) add(column, row);
    }
};

/// Lists the tiles of each primitive, in order.
void list_tiles(GeometrySet& set, const Binner& binner, std::vector<BinEntry>& entries) {
    entries.clear();
    set.tiles = {};
    std::uint32_t i = 0;
    for (std::size_t k = 0; k < set.parts.size(); ++k) {
        const std::size_t end = set.end_of(k, &GeometryPart::primitive, set.primitives.size());
        TileRange of_part;
        for (; i < end; ++i) {
            const TileRange range = binner.tiles(set.primitives[i]);
            of_part.include(range);
            Binner::for_each_tile(range, [&](std::uint16_t column, std::uint16_t row) {
                entries.push_back({column, row, i});
            });
        }
        set.parts[k].tiles = of_part;
        set.tiles.include(of_part);
    }
}

void make_bins(GeometrySet& set, const Binner& binner, GeometryScratch& scratch) {
    list_tiles(set, binner, scratch.bin_entries);
    const std::size_t columns = std::size_t(set.tiles.x1 - set.tiles.x0);
    const auto bin_of = [&](const BinEntry& e) {
        return std::size_t(e.row - set.tiles.y0) * columns + std::size_t(e.column - set.tiles.x0);
    };
    std::vector<std::uint32_t>& start = set.bin_start;
    start.assign(set.tiles.count() + 1, 0);
    for (const BinEntry& e : scratch.bin_entries) start[bin_of(e) + 1] += 1;
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    scratch.next.assign(start.begin(), start.end() - 1);
    set.bin.resize(scratch.bin_entries.size());
    for (const BinEntry& e : scratch.bin_entries) set.bin[scratch.next[bin_of(e)]++] = e.primitive;
}

}  // namespace

void make_bins(GeometrySet& set, const Profile& profile, const TileGrid& grid,
               GeometryScratch& scratch) {
    if (!set.bin_start.empty() && set.binned.covers(set.jitter)) return;
    set.binned = set.jitter;
    const auto axis = [&](int size, int low, int high) {
        return Axis{profile.subpixel_bits, grid.log2_tile, size, low, high};
    };
    make_bins(set,
              {set, axis(grid.width, set.jitter.low.x, set.jitter.high.x),
               axis(grid.height, set.jitter.low.y, set.jitter.high.y)},
              scratch);
}

}  // namespace gw::fast
