#include "hiddensurface/faces/world_piece.h"

#include "hiddensurface/model/normal.h"

#include <cmath>

namespace gw::hiddensurface {
namespace {

/// The polygon's triangles that belong to the facet: the first and their number.
std::pair<std::size_t, std::size_t> triangles_of(const Polygon& polygon, const WorldFacet& facet) {
    std::size_t first = 0, count = 0;
    for (std::size_t i = 0; i < polygon.triangles.size(); ++i) {
        const std::uint32_t source = polygon.triangles[i].source;
        if (source < facet.first || source - facet.first >= facet.count) continue;
        if (count++ == 0) first = i;
    }
    return {first, count};
}

/// A facet's plane on the grid, negative on the eye's side. Not snapped: the snap tilts the plane of
/// a narrow facet, and its cuts reach far beyond it.
dvec4 window_plane(const Input& input, FacetIndex i) {
    const dvec4 world = unit_plane(facet_of(input, i));
    const dvec4 plane = to_window(world, input.view, input.profile);
    return is_before(world, input.view) ? -plane : plane;
}

}  // namespace

Piece window_piece(const Input& input, const TreePiece& piece) {
    const Polygon& polygon = input.polygons[piece.of.polygon];
    const auto [first, count] = triangles_of(polygon, facet_of(input, piece.of));
    Piece out{.polygon = piece.of.polygon,
              .first = first,
              .count = count,
              .name = name_of(input.polygons, piece)};
    for (const Facet& f : polygon.facets)
        if (f.first >= first && f.first < first + count)
            out.parts.insert(out.parts.end(), f.parts.begin(), f.parts.end());
    const dvec4 plane = window_plane(input, piece.of);
    for (const auto& [by, front] : piece.cuts) {
        const dvec3 line = cut_line(plane, window_plane(input, by));
        const bool negative = front == is_before(unit_plane(facet_of(input, by)), input.view);
        auto [before, behind] = divide(out.parts, dvec4(line.x, line.y, 0, line.z));
        out.parts = negative ? std::move(before) : std::move(behind);
        out.cuts.push_back({line, negative});
    }
    return out;
}

std::string name_of(const std::vector<Polygon>& polygons, const TreePiece& piece) {
    const Polygon& polygon = polygons[piece.of.polygon];
    std::string name = name_of(polygon, piece.of.facet, polygon.world_facets.size());
    for (const auto& [by, front] : piece.cuts) name += front ? 'a' : 'b';
    return name;
}

void log_split(const Input& input, const TreePiece& piece, const TreePiece& by,
               const TreePiece& back, const TreePiece& front, StepLog& log) {
    if (!log.on()) return;
    const auto name = [&](const TreePiece& p) { return name_of(input.polygons, p); };
    const auto distances = distances_of(piece, unit_plane(facet_of(input, by.of)));
    log.add({.action = Action::Split,
             .test = "split",
             .result = "plane",
             .pieces = {name(piece), name(by)},
             .values = {{"distances", distances}},
             .decisive = true,
             .made = {{name(front), window_piece(input, front).parts},
                      {name(back), window_piece(input, back).parts}}});
}

TreeSinks tree_log(const Input& input, Counts& counts, StepLog& log) {
    if (!log.on()) return {};
    const auto on_split = [&](const TreePiece& piece, const TreePiece& by, const TreePiece& back,
                              const TreePiece& front) {
        log_split(input, piece, by, back, front, log);
    };
    const auto on_node = [&](const NewNode& n) {
        counts.planes = n.tree.plane_tests;
        counts.nodes = n.tree.nodes.size();
        counts.splits = n.tree.splits;
        Step step{.action = Action::Decide,
                  .test = "tree-node",
                  .result = n.parent == no_node ? "root"
                            : n.in_front        ? "front"
                                                : "back",
                  .values = {{"node", std::int64_t(n.number)},
                             {"plane", std::vector{n.node.plane.x, n.node.plane.y, n.node.plane.z,
                                                   n.node.plane.w}},
                             {"in_front", std::int64_t(n.front)},
                             {"behind", std::int64_t(n.back)}}};
        if (n.parent != no_node) step.values.emplace_back("parent", std::int64_t(n.parent));
        for (const TreePiece& piece : n.node.pieces)
            step.pieces.push_back(name_of(input.polygons, piece));
        log.add(std::move(step));
    };
    return {on_split, on_node};
}

EyeSink eye_log(const Input& input, StepLog& log) {
    if (!log.on()) return {};
    const dvec4 unit = unit_eye_of(input.view), eye = eye_of(input.view);
    if (unit.w != 0)
        return [&log](std::size_t node, double distance) {
            log.add({.test = "eye-side",
                     .result = distance >= 0 ? "front" : "back",
                     .values = {{"node", std::int64_t(node)}, {"D", distance}}});
        };
    const double length = std::sqrt(dot4(eye, eye));
    return [&log, unit, length](std::size_t node, double product) {
        log.add({.test = "eye-side",
                 .result = product >= 0 ? "front-parallel" : "back-parallel",
                 .values = {{"node", std::int64_t(node)},
                            {"N_d", product / length},
                            {"d", std::vector{unit.x, unit.y, unit.z}}}});
    };
}

}  // namespace gw::hiddensurface
