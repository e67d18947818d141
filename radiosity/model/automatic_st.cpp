// Automatic ST [F2.1].
#include "radiosity/model/facet.h"
#include "radiosity/model/model_builder.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::radiosity {
namespace {

Triangle2 mapped(const Facet& map, const std::array<dvec3, 3>& p) {
    return {map.texel_of(p[0]), map.texel_of(p[1]), map.texel_of(p[2])};
}

void add_planar(ModelBuilder& builder, const Chart& chart, Facet facet, std::uint32_t figure) {
    for (std::uint32_t t : chart.triangles)
        facet.triangles.push_back(mapped(facet, builder.corners(t)));
    builder.add_facet(std::move(facet), chart.triangles, figure);
}

void add_curved(ModelBuilder& builder, const Chart& chart, const Facet& map, std::uint32_t figure) {
    for (std::uint32_t t : chart.triangles)
        builder.add_triangle(t, mapped(map, builder.corners(t)), figure);
}

/// In the plane of a chart, from a point of it: the least and the largest coordinates.
struct Extent {
    dvec2 low{0}, high{0};
};

Extent extent_of(const Surface& surface, const Chart& chart, const dvec3& zero, const dvec3& up) {
    Extent e;
    for (std::uint32_t t : chart.triangles)
        for (std::uint32_t corner : surface.triangles[t]) {
            const dvec3 p = surface.points[corner] - zero;
            const dvec2 st(dot3(p, chart.along), dot3(p, up));
            e.low = {std::min(e.low.x, st.x), std::min(e.low.y, st.y)};
            e.high = {std::max(e.high.x, st.x), std::max(e.high.y, st.y)};
        }
    return e;
}

void add_chart(ModelBuilder& builder, const Chart& chart, const std::string& name) {
    const Surface& surface = builder.surface();
    const dvec3 along = chart.along, up = cross3(chart.normal, along);
    const dvec3& zero = surface.points[surface.triangles[chart.triangles.front()][0]];
    const Extent extent = extent_of(surface, chart, zero, up);
    const dvec2 size = extent.high - extent.low;
    const scene::PixmapChoice& choice = builder.object().pixmap;
    const int width = choice.width ? choice.width : builder.texels(size.x),
              height = choice.height ? choice.height : builder.texels(size.y);
    const std::uint32_t figure = builder.add_figure(builder.add_pixmap(name, width, height));
    const dvec3 corner = zero + (extent.low.x * along + extent.low.y * up);
    const Facet map =
        facet_along(corner, along * (size.x / width), up * (size.y / height), chart.normal);
    chart.planar ? add_planar(builder, chart, map, figure)
                 : add_curved(builder, chart, map, figure);
}

}  // namespace

void add_automatic(ModelBuilder& builder) {
    const std::vector<Chart> found = charts(builder.surface());
    if (found.empty()) builder.fail_without_area();
    const std::string& name = builder.object().name;
    for (std::size_t i = 0; i < found.size(); ++i)
        add_chart(builder, found[i], found.size() > 1 ? fmt::format("{} {}", name, i + 1) : name);
}

}  // namespace gw::radiosity
