// The BSP tree's order [L5]: the tree knows no eye; the eye's side of each plane gives the order. Cuts made
// in the world are drawn as lines between pixels, so every polygon keeps its pixels.
#include "hiddensurface/algorithm.h"
#include "hiddensurface/bsp_tree.h"
#include "hiddensurface/normal.h"

#include <numeric>

namespace gw::hiddensurface {

namespace {

constexpr std::size_t candidates = 8;

const WorldFacet& facet(const Input& input, FacetIndex i) {
    return input.polygons[i.polygon].world_facets[i.facet];
}

/// The polygon's triangles that are of the facet: the first and how many.
std::pair<std::size_t, std::size_t> triangles_of(const Polygon& polygon, const WorldFacet& facet) {
    std::size_t first = 0, count = 0;
    for (std::size_t i = 0; i < polygon.triangles.size(); ++i) {
        const std::uint32_t source = polygon.triangles[i].source;
        if (source < facet.first || source - facet.first >= facet.count) continue;
        if (count++ == 0) first = i;
    }
    return {first, count};
}

/// A facet's plane on the grid, negative before it, where the eye is. Without the snap: that tilts the plane
/// of a narrow facet, and its cuts reach far beyond it.
dvec4 window_plane(const Input& input, FacetIndex i) {
    const dvec4 world = unit_plane(facet(input, i));
    const dvec4 plane = to_window(world, input.view, input.profile);
    return is_before(world, input.view) ? -plane : plane;
}

Piece window_piece(const Input& input, const TreePiece& piece) {
    const Polygon& polygon = input.polygons[piece.of.polygon];
    const auto [first, count] = triangles_of(polygon, facet(input, piece.of));
    Piece out{.polygon = piece.of.polygon, .first = first, .count = count};
    for (const Facet& f : polygon.facets)
        if (f.first >= first && f.first < first + count)
            out.parts.insert(out.parts.end(), f.parts.begin(), f.parts.end());
    const dvec4 plane = window_plane(input, piece.of);
    for (const auto& [by, front] : piece.cuts) {
        const dvec3 line = cut_line(plane, window_plane(input, by));
        const bool negative = front == is_before(unit_plane(facet(input, by)), input.view);
        auto [before, behind] = divide(out.parts, dvec4(line.x, line.y, 0, line.z));
        out.parts = negative ? std::move(before) : std::move(behind);
        out.cuts.push_back({line, negative});
    }
    return out;
}

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "BSP tree")};
    std::vector<std::size_t> order(input.polygons.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto on_split = [&](const TreePiece& piece, FacetIndex by, const std::vector<Loop>& back,
                              const std::vector<Loop>& front) {
        log.add({Level::Polygon,
                 Action::Split,
                 {input.polygons[piece.of.polygon].id, input.polygons[by.polygon].id},
                 "by the second's plane",
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
    output.counts.facings = far_to_near(tree, eye_of(input.view), [&](const TreePiece& piece) {
        const Piece drawn = window_piece(input, piece);
        if (drawn.count > 0) draw_piece(input, drawn, output, log);
    });
    return output;
}

}  // namespace

Algorithm bsp() {
    return {.place = 40,
            .name = "bsp",
            .title = "BSP tree, built before the eye is known [L5]",
            .claim = Claim::Always,
            .in_world = true,
            .run = run};
}

}  // namespace gw::hiddensurface
