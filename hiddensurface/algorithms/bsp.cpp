// The BSP tree's order [L5]: the tree knows no eye; the eye's side of each plane gives the order. Cuts made
// in the world are drawn as lines between pixels, so every polygon keeps its pixels.
#include "hiddensurface/algorithm.h"
#include "hiddensurface/bsp_tree.h"
#include "hiddensurface/normal.h"

#include <numeric>

namespace gw::hiddensurface {

namespace {

constexpr std::size_t candidates = 8;

dvec4 eye_of(const scene::Camera& camera) {
    return camera.ortho_height > 0 ? dvec4(camera.eye - camera.at, 0) : dvec4(camera.eye, 1);
}

/// The plane of polygon i on the grid, negative on the side its world normal points to or not.
struct WindowPlane {
    dvec4 plane;
    bool normal_is_negative;
};

WindowPlane window_plane(const Input& input, std::size_t i) {
    const Polygon& polygon = input.polygons[i];
    const dvec4 world = plane_of(polygon_normal(polygon.world), polygon.world[0]);
    if (!polygon.visible()) return {to_window(world, input.view, input.profile), false};
    // Plane has n.z >= 0 and is negative before it: where the eye is.
    return {polygon.plane, dot4(world, eye_of(input.view.camera)) > 0};
}

Piece window_piece(const Input& input, const TreePiece& piece) {
    const Polygon& polygon = input.polygons[piece.polygon];
    Piece out{piece.polygon, polygon.parts, {}};
    for (const auto& [by, front] : piece.cuts) {
        const WindowPlane cut = window_plane(input, by);
        const bool negative = front == cut.normal_is_negative;
        auto [before, behind] = divide(out.parts, cut.plane);
        out.parts = negative ? std::move(before) : std::move(behind);
        out.cuts.push_back({cut_line(polygon.plane, cut.plane), negative});
    }
    return out;
}

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "BSP tree")};
    std::vector<std::size_t> order(input.polygons.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto on_split = [&](const TreePiece& piece, std::size_t by, const std::vector<Loop>& back,
                              const std::vector<Loop>& front) {
        log.add({Level::Polygon,
                 Action::Split,
                 {input.polygons[piece.polygon].id, input.polygons[by].id},
                 "by the plane of the second, in the world",
                 "",
                 -1,
                 {},
                 front,
                 back});
    };
    const Tree tree = build_tree(input.polygons, order, candidates, on_split);
    output.counts.planes = tree.plane_tests;
    output.counts.nodes = tree.nodes;
    output.counts.splits = tree.splits;
    output.counts.peak_bytes = tree.nodes * sizeof(TreeNode) + tree.pieces * sizeof(TreePiece);
    output.counts.facings = far_to_near(tree, eye_of(input.view.camera), [&](const TreePiece& piece) {
        if (input.polygons[piece.polygon].visible())
            draw_piece(input, window_piece(input, piece), output, log);
    });
    return output;
}

}  // namespace

Algorithm bsp() {
    return {.place = 40,
            .name = "bsp",
            .title = "BSP tree, built before the eye is known [L5]",
            .claim = Claim::Always,
            .run = run};
}

}  // namespace gw::hiddensurface
