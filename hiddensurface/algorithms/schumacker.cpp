// Schumacker's clusters and a-priori order. R. A. Schumacker, B. Brand, M. Gilliland, W. Sharp:
// Study for Applying Computer-Generated Images to Visual Simulation, US Air Force AFHRL-TR-69-14,
// 1969. A cluster is a set of faces with priorities that hold for every eye, back faces apart: a
// face that hides another from any eye has the smaller number. Planes separate the clusters; the
// eye's side of each plane gives their order, as later in the BSP tree. All of it is computed before
// the eye is known; nothing is sorted for an eye.
//
// Does not claim: priorities of faces that pierce, or hide each other in a cycle. In the original,
// the scene's author kept such faces in different clusters. Here a set without priorities is divided
// by a plane between its faces. If there is none, the plane of a face divides it and cuts others
// (counted: splits). Every face of a cluster is compared with every other. That is quadratic, so
// clusters have at most 512 faces, except convex solids, whose outer sides come before all inner ones.
//
// Ours: both sides of every face, since the machine draws both.
#include "hiddensurface/faces/world_piece.h"
#include "hiddensurface/structures/clusters.h"

namespace gw::hiddensurface {
namespace {

/// The tree's nodes: separating planes and clusters with the priorities of their sides.
void log_clusters(const Input& input, const ClusterTree& tree, StepLog& log) {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const ClusterNode& node = tree.nodes[i];
        const bool plane = node.front != no_node;
        Step step{.action = Action::Decide,
                  .test = "cluster",
                  .result = plane ? "separated" : "ranked",
                  .values = {{"node", std::int64_t(i)}},
                  .decisive = plane};
        const dvec4& p = node.plane;
        if (plane) {
            step.values.emplace_back("plane", std::vector{p.x, p.y, p.z, p.w});
            step.values.emplace_back("front", std::int64_t(node.front));
            step.values.emplace_back("back", std::int64_t(node.back));
        } else {
            std::vector<std::int64_t> front(node.pieces.size()), back(node.pieces.size());
            for (const RankedSide& side : node.sides)
                (side.front ? front : back)[side.piece] = std::int64_t(side.priority);
            step.values.emplace_back("front", front);
            step.values.emplace_back("back", back);
        }
        for (const TreePiece& piece : node.pieces)
            step.pieces.push_back(name_of(input.polygons, piece));
        log.add(std::move(step));
    }
}

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "Schumacker's clusters")};
    if (input.polygons.empty()) return output;
    log.watch(watched(output.counts));
    const ClusterTree tree = build_clusters(
        input.polygons,
        [&](const TreePiece& piece, const TreePiece& by, const TreePiece& back,
            const TreePiece& front) { log_split(input, piece, by, back, front, log); });
    output.counts.planes = tree.plane_tests;
    output.counts.nodes = tree.clusters + tree.separations;
    output.counts.splits = tree.splits;
    output.counts.peak_bytes = tree.comparison_bytes + output.counts.nodes * sizeof(ClusterNode) +
                               tree.pieces * (sizeof(TreePiece) + 2 * sizeof(RankedSide));
    if (log.on()) log_clusters(input, tree, log);
    const auto draw = [&](const TreePiece& piece, const RankedSide& side) {
        const Piece drawn = window_piece(input, piece);
        if (drawn.count == 0) return;
        if (log.on())
            log.add({.action = Action::Decide,
                     .test = "priority",
                     .result = side.front ? "front" : "back",
                     .pieces = {drawn.name},
                     .values = {{"priority", std::int64_t(side.priority)}}});
        draw_piece(input, drawn, output, log);
    };
    output.counts.facings =
        far_to_near(tree, input.polygons, eye_of(input.view), draw, eye_log(input, log));
    return output;
}

}  // namespace

Algorithm schumacker() {
    return {.name = "schumacker",
            .title = "Schumacker's clusters: priorities for every eye (1969)",
            .claim = Claim::Always,
            .in_world = true,
            .growth = {GrowthLaw::Superlinear, 30},
            .run = run};
}

}  // namespace gw::hiddensurface
