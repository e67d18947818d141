// The state of a geometry set, its memory and the range of its jitter. Does not make it.
#include "gw/fast/vertices/geometry.h"

#include <algorithm>

namespace gw::fast {

GeometryState geometry_state(const State& s) {
    return {s.projection, s.viewport,     s.depth_range, s.clip_planes,
            s.cull,       s.polygon_mode, s.point_size,  s.line_width};
}

void JitterRange::include(const JitterState& j) {
    low = {std::min(low.x, j.x), std::min(low.y, j.y)};
    high = {std::max(high.x, j.x), std::max(high.y, j.y)};
}
bool JitterRange::covers(const JitterRange& o) const {
    return low.x <= o.low.x && low.y <= o.low.y && high.x >= o.high.x && high.y >= o.high.y;
}

void TileRange::include(const TileRange& o) {
    if (o.count() == 0) return;
    if (count() == 0) {
        *this = o;
        return;
    }
    x0 = std::min(x0, o.x0);
    y0 = std::min(y0, o.y0);
    x1 = std::max(x1, o.x1);
    y1 = std::max(y1, o.y1);
}

void GeometrySet::clear() {
    parts.clear();
    at.clear();
    w.clear();
    primitives.clear();
    triangle_count = 0;
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
}

std::size_t GeometrySet::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return sizeof(*this) + of(parts) + of(at) + of(w) + of(primitives) + of(clipped) + of(used) +
           of(used_front) + of(used_back) + of(bin_start) + of(bin);
}

}  // namespace gw::fast
