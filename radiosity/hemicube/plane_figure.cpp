#include "radiosity/hemicube/plane_figure.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The convex hull, counterclockwise; a corner that bends by next to nothing is left out.
std::vector<dvec2> hull(std::vector<dvec2> points) {
    std::sort(points.begin(), points.end(), [](const dvec2& a, const dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<dvec2> corners;
    const auto add_chain = [&](auto first, auto last) {
        const std::size_t least = corners.size() + 1;
        for (auto p = first; p != last; ++p) {
            while (corners.size() > least &&
                   turn(corners[corners.size() - 2], corners.back(), *p) <= 1e-9)
                corners.pop_back();
            corners.push_back(*p);
        }
        corners.pop_back();
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return corners;
}

bool contains(const std::vector<dvec2>& outline, const dvec2& p) {
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (turn(outline[i], outline[i + 1 < outline.size() ? i + 1 : 0], p) < -1e-9) return false;
    return true;
}

bool is_whole(const PlaneFigure& figure, int u, int v) {
    for (const dvec2& corner : {dvec2(u, v), dvec2(u + 1, v), dvec2(u, v + 1), dvec2(u + 1, v + 1)})
        if (!contains(figure.outline, corner)) return false;
    return true;
}

double radius_of_bounds(const Facet& facet) {
    double radius = 0;
    for (const dvec2& corner : {facet.low, dvec2(facet.high.x, facet.low.y), facet.high,
                                dvec2(facet.low.x, facet.high.y)})
        radius = std::max(radius, length(facet.at(corner) - facet.center));
    return radius;
}

void find_cuts(PlaneFigure& figure) {
    constexpr double little = 1e-9;
    for (int v = figure.first.y; v < figure.end.y; ++v)
        for (int u = figure.first.x; u < figure.end.x; ++u) {
            if (is_whole(figure, u, v)) continue;
            const Polygon2 part = part_in_texel(figure, u, v);
            const double share = part.n < 3 ? 0 : area(part);
            if (share > little)
                figure.cuts.push_back({u, v, centroid(part), share});
            else
                figure.cuts.push_back({u, v, dvec2(u + 0.5, v + 0.5), 0});
        }
}

}  // namespace

Polygon2 part_in_texel(const PlaneFigure& figure, int u, int v) {
    Polygon2 polygon;
    for (const dvec2& corner : figure.outline) polygon.add(corner);
    return cut_to_box(polygon, {u, v}, {u + 1, v + 1});
}

std::vector<std::optional<PlaneFigure>> plane_figures(const PixmapModel& model) {
    std::vector<std::optional<PlaneFigure>> figures(model.facets.size());
    for (std::uint32_t i = 0; i < model.facets.size(); ++i) {
        const Facet& facet = model.facets[i];
        const Pixmap& pixmap = model.pixmaps[facet.pixmap];
        std::vector<dvec2> corners;
        for (const Triangle2& t : facet.triangles)
            corners.insert(corners.end(), t.begin(), t.end());
        PlaneFigure figure{.facet = i, .outline = hull(std::move(corners)), .cuts = {}};
        if (figure.outline.size() < 3 || figure.outline.size() > PlaneFigure::most_corners)
            continue;
        const auto first = [](double low) { return static_cast<int>(std::floor(low + 1e-9)); };
        const auto end = [](double high, int count) {
            return std::min(count, static_cast<int>(std::ceil(high - 1e-9)));
        };
        figure.first = {first(facet.low.x), first(facet.low.y)};
        figure.end = {end(facet.high.x, pixmap.width), end(facet.high.y, pixmap.height)};
        figure.radius = radius_of_bounds(facet);
        find_cuts(figure);
        figures[i] = std::move(figure);
    }
    return figures;
}

}  // namespace gw::radiosity
