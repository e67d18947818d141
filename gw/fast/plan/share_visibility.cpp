#include "gw/fast/plan/plan.h"

#include "gw/stages/raster/points.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace gw::fast {

namespace {

/// Stippled and antialiased fragments are not those of the covered centres. Records know one colour
/// plane, and no rare values.
bool is_special(const State& s) {
    return s.line_stipple.enable || s.polygon_stipple.pattern || antialiases(s) ||
           draws_to_both(s) || sizes_points(s) || s.point_sprite;
}

/// Records know no outer pixels.
bool has_outer_pixels(const DrawOp& op) {
    return op.state.state.diamond_lines && op.set->triangle_count != op.set->primitives.size();
}

bool may_share(const DrawOp& op) {
    const State& s = op.state.state;
    if (has_rare_values(op) || has_outer_pixels(op)) return false;
    const StencilFace& face = op.state.front;
    const bool counts_visible = face.func == StencilFunc::Always && face.zfail == StencilOp::Keep;
    return s.depth.func == DepthFunc::Equal && !is_special(s) && !op.units &&
           s.alpha.func == AlphaFunc::Always && (keeps_stencil(face) || counts_visible) &&
           !(s.stencil.test && s.stencil.two_side);
}

/// Everything that decides a draw's fragments and their depths.
struct FragmentsKey {
    const PartGroup* group;
    JitterState jitter;
    Rect box;
    PolygonOffsetState offset;
    bool operator==(const FragmentsKey&) const = default;
};
FragmentsKey fragments_key(const DrawOp& op) {
    return {op.group, op.state.state.jitter, op.state.draw_box, op.state.state.polygon_offset};
}

/// How an operation changes depths: `Less` never makes one greater. Under Equal a written depth is
/// the stored one.
enum class Change { None, Less, Any };

Change change(const DepthState& depth) {
    if (!depth.mask || depth.func == DepthFunc::Equal || depth.func == DepthFunc::Never)
        return Change::None;
    return depth.func == DepthFunc::Less || depth.func == DepthFunc::LEqual ? Change::Less
                                                                            : Change::Any;
}
Change change(const DrawOp& op) { return change(op.state.state.depth); }
Change change(const SpansOp& op) { return change(op.state.state.depth); }
Change change(const PixelsOp& op) {
    return op.write->plane == Plane::Depth ? Change::Any : change(op.state.state.depth);
}
Change change(const DrawPixelsOp& op) { return change(op.state.state.depth); }
Change change(const ClearOp& op) {
    return op.planes & mask_of(Plane::Depth) ? Change::Any : Change::None;
}
Change change(const AccumulateOp&) { return Change::None; }
Change change(const ReadOp&) { return Change::None; }

/// Whether a draw is a depth pass of triangles only, all of whose fragments reach the depth test.
bool may_record(const DrawOp& op) {
    const State& s = op.state.state;
    return change(op) == Change::Less && !is_special(s) && !has_rare_values(op) && !op.units &&
           s.alpha.func == AlphaFunc::Always && !s.polygon_offset.enable &&
           ignores_stencil(op.state.front) && ignores_stencil(op.state.back) &&
           op.set->triangle_count == op.set->primitives.size();
}

std::uint64_t hash_of(const FragmentsKey& key) {
    return Hash()
        .add(key.group)
        .add(std::uint64_t(key.jitter.x) << 32 | std::uint32_t(key.jitter.y))
        .value();
}

/// Draws of one record.
struct Group {
    FragmentsKey key;
    int depth_version;
    DrawOp* depth_pass;  ///< null: the first of `draws` makes the record
    std::vector<DrawOp*> draws;
};

/// The last depth pass of a geometry; it makes one record.
struct DepthPass {
    FragmentsKey key;
    int epoch;  ///< depths have not grown since
    DrawOp* op;
};

struct Grouping {
    std::deque<Group> groups;
    PointerTable<Group> group_table;
    std::deque<DepthPass> depth_passes;
    PointerTable<DepthPass> depth_pass_table;
    int depth_version = 0, epoch = 0;

    DepthPass* depth_pass(const FragmentsKey& key) const {
        return depth_pass_table.find(hash_of(key),
                                     [&](const DepthPass& pass) { return pass.key == key; });
    }
    DrawOp* take_depth_pass(const FragmentsKey& key) {
        DepthPass* const found = depth_pass(key);
        return found && found->epoch == epoch ? std::exchange(found->op, nullptr) : nullptr;
    }
    void add_depth_pass(DrawOp& op) {
        const FragmentsKey key = fragments_key(op);
        if (DepthPass* const found = depth_pass(key)) {
            *found = {key, epoch, &op};
            return;
        }
        depth_pass_table.add(hash_of(key), &depth_passes.emplace_back(DepthPass{key, epoch, &op}));
    }
    void add(DrawOp& op) {
        const FragmentsKey key = fragments_key(op);
        const std::uint64_t hash =
            Hash().add(hash_of(key)).add(std::uint64_t(depth_version)).value();
        Group* const found = group_table.find(
            hash, [&](const Group& g) { return g.key == key && g.depth_version == depth_version; });
        if (found) {
            found->draws.push_back(&op);
            return;
        }
        groups.push_back({key, depth_version, take_depth_pass(key), {&op}});
        group_table.add(hash, &groups.back());
    }
    void pass_by(const TileOp& op) {
        const Change c = std::visit([](const auto& o) { return change(o); }, op.op);
        if (c == Change::Any) epoch += 1;
        if (c != Change::None) depth_version += 1;
    }
};

}  // namespace

void share_visibility(Segment& segment) {
    Grouping grouping;
    for (TileOp& tile_op : segment.ops) {
        DrawOp* op = std::get_if<DrawOp>(&tile_op.op);
        if (op && may_share(*op)) grouping.add(*op);
        grouping.pass_by(tile_op);
        if (op && may_record(*op)) grouping.add_depth_pass(*op);
    }
    for (Group& group : grouping.groups) {
        if (group.draws.size() < 2 && !group.depth_pass) continue;
        if (group.depth_pass) group.draws.push_back(group.depth_pass);
        const bool by_pixel = std::any_of(
            group.draws.begin(), group.draws.end(),
            [](const DrawOp* op) { return op->state.front.func != StencilFunc::Always; });
        for (DrawOp* op : group.draws) {
            op->visible_record = segment.visible_records;
            op->counts_by_pixel = by_pixel;
        }
        segment.visible_records += 1;
    }
}

}  // namespace gw::fast
