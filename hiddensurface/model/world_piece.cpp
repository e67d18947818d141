#include "hiddensurface/model/world_piece.h"

#include "hiddensurface/model/normal.h"

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
    Piece out{.polygon = piece.of.polygon, .first = first, .count = count};
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

void log_split(const Input& input, const TreePiece& piece, FacetIndex by,
               const std::vector<Loop>& back, const std::vector<Loop>& front, StepLog& log) {
    if (!log.on()) return;
    log.add({Level::Polygon,
             Action::Split,
             {input.polygons[piece.of.polygon].id, input.polygons[by.polygon].id},
             "by the second's plane",
             "",
             -1,
             {},
             front,
             back});
}

}  // namespace gw::hiddensurface
