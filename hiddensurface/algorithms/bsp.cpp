// The BSP tree's order [L5]: the tree knows no eye; the eye's side of each plane gives the order.
#include "hiddensurface/faces/world_piece.h"

#include <numeric>

namespace gw::hiddensurface {
namespace {

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "BSP tree")};
    std::vector<std::size_t> order(input.polygons.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    log.watch(watched(output.counts));
    const Tree tree =
        build_tree(input.polygons, order, splitters_tried, tree_log(input, output.counts, log));
    output.counts.planes = tree.plane_tests;
    output.counts.nodes = tree.nodes.size();
    output.counts.splits = tree.splits;
    output.counts.peak_bytes =
        output.counts.nodes * sizeof(TreeNode) + tree.pieces * sizeof(TreePiece);
    const auto draw = [&](const TreePiece& piece) {
        const Piece drawn = window_piece(input, piece);
        if (drawn.count > 0) draw_piece(input, drawn, output, log);
    };
    output.counts.facings = far_to_near(tree, eye_of(input.view), draw, eye_log(input, log));
    return output;
}

}  // namespace

Algorithm bsp() {
    return {.name = "bsp",
            .title = "BSP tree, built before the eye is known [L5]",
            .claim = Claim::Always,
            .in_world = true,
            .growth = {GrowthLaw::Superlinear, 10},
            .run = run};
}

}  // namespace gw::hiddensurface
