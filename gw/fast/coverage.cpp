// Which draws share a record.
#include "gw/fast/coverage.h"

#include "gw/fast/plan.h"

#include <algorithm>

namespace gw::fast {

void Coverage::clear() {
    made = false;
    primitives.clear();
    blocks.clear();
    fragments.clear();
    total = 0;
    runs.clear();
    texture.texcoords = nullptr;
}

namespace {

bool may_share(const DrawOp& op) {
    const State& s = op.state.state;
    return s.depth.func == DepthFunc::Equal && s.alpha.func == AlphaFunc::Always && keeps(op.state.front) &&
           keeps(op.state.back) && !(s.stencil.test && s.stencil.two_side);
}

/// What decides a draw's fragments and their depths.
struct Shared {
    const GeometrySet* set;
    JitterState jitter;
    Rect box;
    PolygonOffsetState offset;
    int depth_version;
    bool operator==(const Shared&) const = default;
};

/// Under Equal a written depth is the stored one.
bool changes_depth(const DrawOp& op) {
    return op.state.state.depth.mask && op.state.state.depth.func != DepthFunc::Equal;
}
bool changes_depth(const ClearOp& op) { return (op.clear->planes & mask_of(Plane::Depth)) != 0; }
bool changes_depth(const SpansOp& op) {
    return op.state.state.depth.mask && op.state.state.depth.func != DepthFunc::Equal;
}
bool changes_depth(const PixelsOp& op) {
    return op.write->plane == Plane::Depth ||
           (op.state.state.depth.mask && op.state.state.depth.func != DepthFunc::Equal);
}
bool changes_depth(const AccumulateOp&) { return false; }
bool changes_depth(const ReadOp&) { return false; }

}  // namespace

void plan_coverages(Segment& segment) {
    std::vector<std::pair<Shared, std::vector<DrawOp*>>> groups;
    int depth_version = 0;
    for (TileOp& tile_op : segment.ops) {
        DrawOp* op = std::get_if<DrawOp>(&tile_op.op);
        if (op && may_share(*op)) {
            const State& s = op->state.state;
            const Shared key{op->set, s.jitter, op->state.draw_box, s.polygon_offset, depth_version};
            const auto found =
                std::find_if(groups.rbegin(), groups.rend(), [&](const auto& g) { return g.first == key; });
            if (found != groups.rend())
                found->second.push_back(op);
            else
                groups.push_back({key, {op}});
        }
        depth_version += std::visit([](const auto& o) { return changes_depth(o); }, tile_op.op) ? 1 : 0;
    }
    for (const auto& [key, ops] : groups) {
        if (ops.size() < 2) continue;
        for (DrawOp* op : ops) op->coverage = segment.coverages;
        segment.coverages += 1;
    }
}

}  // namespace gw::fast
