// The state of a geometry set, its memory and the range of its jitter. Does not make it.
#include "gw/fast/vertices/geometry.h"

#include "gw/stages/polygon_offset.h"
#include "gw/stages/raster/points.h"

#include <algorithm>

namespace gw::fast {

namespace {

/// Half the size would do, rounded up; a smooth primitive reaches into more pixels.
int margin(float size, bool smooth) { return whole_size(size) + (smooth ? 2 : 0); }

}  // namespace

GeometryState geometry_state(const State& s, int subpixel_bits) {
    const PolygonOffsetState& offset = s.polygon_offset;
    return {.projection = s.projection,
            .viewport = s.viewport,
            .depth_range = s.depth_range,
            .clip_control = s.clip_control,
            .clip_planes = s.clip_planes,
            .cull = s.cull,
            .polygon_mode = s.polygon_mode,
            .back_polygon_mode = mode_of(s, false),
            .keeps_slopes = {offsets_outline(offset, mode_of(s, false)),
                             offsets_outline(offset, s.polygon_mode)},
            .stipple_period = s.line_stipple.enable ? 16 * s.line_stipple.factor : 0,
            .point_margin = margin(sizes_points(s) ? s.point_parameters.max_size : s.point_size,
                                   smooths_points(s)),
            .line_margin = margin(s.line_width, s.line_smooth),
            .fill_margin = s.polygon_smooth ? 1 : 0,
            .line_smooth = s.line_smooth,
            .line_rule = s.line_stipple.enable ? line_rule(s, subpixel_bits) : LineRule{}};
}

void JitterRange::include(const JitterState& j) {
    low = {std::min(low.x, j.x), std::min(low.y, j.y)};
    high = {std::max(high.x, j.x), std::max(high.y, j.y)};
}
bool JitterRange::covers(const JitterRange& o) const {
    return low.x <= o.low.x && low.y <= o.low.y && high.x >= o.high.x && high.y >= o.high.y;
}

void PartGroup::finish() {
    const std::uint32_t end = first_part + parts;
    first_primitive = set->parts[first_part].primitive;
    end_primitive =
        std::uint32_t(set->end_of(end - 1, &GeometryPart::primitive, set->primitives.size()));
    if (parts == set->parts.size()) return void(tiles = set->tiles);
    tiles = {};
    for (std::uint32_t i = first_part; i < end; ++i) tiles.include(set->parts[i].tiles);
}

std::span<const std::uint32_t> PartGroup::tile_bin(int column, int row) const {
    const std::span<const std::uint32_t> bin = set->tile_bin(column, row);
    if (parts == set->parts.size()) return bin;
    const auto first = std::lower_bound(bin.begin(), bin.end(), first_primitive);
    return {first, std::lower_bound(first, bin.end(), end_primitive)};
}

Counters PartGroup::counters() const {
    if (parts == set->parts.size()) return set->counters;
    Counters sum;
    for (std::uint32_t i = first_part; i < first_part + parts; ++i) {
        const PartCounts& part = set->parts[i].counts;
        sum.draws += 1;
        sum.vertices += part.vertices;
        sum.primitives += part.primitives;
        sum.rejected += part.rejected;
        sum.clipped += part.clipped;
        sum.degenerate += part.degenerate;
        sum.culled += part.culled;
        sum.drawn += part.drawn;
    }
    return sum;
}

void GeometrySet::clear() {
    parts.clear();
    at.clear();
    w.clear();
    primitives.clear();
    triangle_count = 0;
    outline_slope.clear();
    clipped.clear();
    lists_used = lists_made = made = false;
    used.clear();
    used_front.clear();
    used_back.clear();
    counters = {};
    jitter = binned = {};
    tiles = {};
    bin_start.clear();
    bin.clear();
    first_mesh.reset();
}

std::size_t GeometrySet::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return sizeof(*this) + of(parts) + of(at) + of(w) + of(primitives) + of(clipped) + of(used) +
           of(used_front) + of(used_back) + of(bin_start) + of(bin);
}

}  // namespace gw::fast
