// The key of a geometry set, and how a set takes over the contents of another. Does not make them.
#include "gw/fast/vertices/geometry.h"

#include "gw/command_list.h"

#include <algorithm>
#include <utility>

namespace gw::fast {

GeometryKey geometry_key(const State& s, const Draw& draw) {
    return {draw.mesh,     draw.eye_from_object, s.projection, s.viewport,
            s.depth_range, s.clip_planes,        s.cull,       s.polygon_mode,
            s.point_size,  s.line_width};
}

void JitterRange::include(const JitterState& j) {
    low = {std::min(low.x, j.x), std::min(low.y, j.y)};
    high = {std::max(high.x, j.x), std::max(high.y, j.y)};
}
bool JitterRange::covers(const JitterRange& o) const {
    return low.x <= o.low.x && low.y <= o.low.y && high.x >= o.high.x && high.y >= o.high.y;
}

void GeometrySet::take(GeometrySet& from) {
    from.key = std::move(key);
    from.lists_used = lists_used;
    from.jitter = jitter;
    *this = std::move(from);
}

void GeometrySet::take_memory(GeometrySet& from) {
    const auto take = [&](auto member) {
        (from.*member).clear();
        (from.*member).swap(this->*member);
    };
    take(&GeometrySet::at);
    take(&GeometrySet::w);
    take(&GeometrySet::primitives);
    take(&GeometrySet::clipped);
    take(&GeometrySet::used);
    take(&GeometrySet::used_front);
    take(&GeometrySet::used_back);
    take(&GeometrySet::bin_start);
    take(&GeometrySet::bin);
}

}  // namespace gw::fast
