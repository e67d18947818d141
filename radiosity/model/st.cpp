// The ST of figures [F2, F2.1]. Automatic ones are a projection for each chart. Given ones may be
// rotated, sheared, mirrored or triangular, with several figures in one pixmap.
#include "radiosity/model/model_builder.h"
#include "radiosity/model/texel_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// The pixmap of a chart, and the map to its texels.
struct Projection {
    int width = 0, height = 0;
    Facet map;
};

Projection projection_of(const ModelBuilder& builder, const Chart& chart) {
    const Surface& surface = builder.surface();
    const dvec3 along = chart.along, up = cross3(chart.normal, along);
    const dvec3& zero = surface.points[surface.triangles[chart.triangles.front()][0]];
    const Extent extent = extent_of(surface, chart, zero, up);
    const dvec2 size = extent.high - extent.low;
    const scene::PixmapChoice& choice = builder.object().pixmap;
    const int width = choice.width ? choice.width : builder.texels(size.x),
              height = choice.height ? choice.height : builder.texels(size.y);
    const dvec3 corner = zero + (extent.low.x * along + extent.low.y * up);
    return {width, height,
            facet_along(corner, along * (size.x / width), up * (size.y / height), chart.normal)};
}

/// Triangles of a chart that cover texels of its pixmap which those before them fill: of doubled
/// faces, spirals and folds.
std::vector<std::uint32_t> overlapping(const ModelBuilder& builder, const Chart& chart) {
    const Projection onto = projection_of(builder, chart);
    Pixmap pixmap;
    pixmap.width = onto.width;
    pixmap.height = onto.height;
    std::vector<double> share(pixmap.count());
    std::vector<std::uint32_t> over;
    std::vector<std::pair<std::size_t, double>> parts;
    for (const std::uint32_t t : chart.triangles) {
        parts.clear();
        bool fits = true;
        for_each_part(
            mapped(onto.map, builder.corners(t)), pixmap, [&](int x, int y, const Polygon2& part) {
                const std::size_t texel = std::size_t(y) * std::size_t(onto.width) + std::size_t(x);
                parts.emplace_back(texel, area(part));
                fits = fits && share[texel] + area(part) <= most_share;
            });
        if (!fits) {
            over.push_back(t);
            continue;
        }
        for (const auto& [texel, covered] : parts) share[texel] += covered;
    }
    return over;
}

/// In charts that cover no texel twice.
std::vector<Chart> flat_charts(const ModelBuilder& builder) {
    const Surface& surface = builder.surface();
    std::vector<Chart> found = charts(surface);
    for (std::size_t i = 0; i < found.size();) {
        std::vector<std::uint32_t> over = overlapping(builder, found[i]);
        if (over.empty()) {
            ++i;
            continue;
        }
        std::vector<std::uint32_t> rest;
        const std::vector<std::uint32_t>& all = found[i].triangles;
        std::set_difference(all.begin(), all.end(), over.begin(), over.end(),
                            std::back_inserter(rest));
        found[i] = chart_of(surface, std::move(rest));
        found.insert(found.begin() + std::ptrdiff_t(i) + 1, chart_of(surface, std::move(over)));
    }
    return found;
}

void add_chart(ModelBuilder& builder, const Chart& chart, const std::string& name) {
    const auto [width, height, map] = projection_of(builder, chart);
    const std::uint32_t figure = builder.add_figure(builder.add_pixmap(name, width, height));
    chart.planar ? add_planar(builder, chart, map, figure)
                 : add_curved(builder, chart, map, figure);
}

void check_st(const ModelBuilder& builder) {
    const MeshData& data = builder.object().mesh->data();
    if (data.texcoords.empty())
        builder.fail(
            "its vertices have no texture coordinates; expected some beside st = \"texcoords\"");
    for (const vec2& st : data.texcoords)
        if (!(st.x >= -1e-6f && st.x <= 1 + 1e-6f && st.y >= -1e-6f && st.y <= 1 + 1e-6f))
            builder.fail(
                fmt::format("ST ({}, {}) lie outside its pixmap; expected 0 to 1", st.x, st.y));
}

class Given {
public:
    explicit Given(ModelBuilder& builder) : builder_(builder) {}

    void add() {
        const std::uint32_t figure = builder_.add_figure(builder_.add_shared_pixmap());
        const auto triangles = builder_.object().mesh->triangles();
        for (std::uint32_t t = 0; t < triangles.size();) {
            std::uint32_t end = t + 1;
            while (end < triangles.size() && triangles[end].polygon == triangles[t].polygon) ++end;
            add_polygon(t, end, figure);
            t = end;
        }
    }

private:
    Triangle2 uv_of(std::uint32_t t) const {
        const Pixmap& pixmap = builder_.model.pixmaps[builder_.model.figures.back().pixmap];
        const Mesh& mesh = *builder_.object().mesh;
        Triangle2 uv;
        for (std::size_t k = 0; k < 3; ++k) {
            const vec2 st = mesh.data().texcoords[mesh.triangles()[t].vertex[k]];
            uv[k] = {std::clamp(double(st.x), 0.0, 1.0) * pixmap.width,
                     std::clamp(double(st.y), 0.0, 1.0) * pixmap.height};
        }
        return uv;
    }

    // One facet if the whole polygon has one affine map, else one for each triangle.
    void add_polygon(std::uint32_t first, std::uint32_t end, std::uint32_t figure) {
        std::vector<std::uint32_t> solid;
        for (std::uint32_t t = first; t < end; ++t)
            if (builder_.surface().solid(t)) solid.push_back(t);
        if (solid.empty()) return;
        if (std::optional<Facet> facet = one_map(solid)) {
            for (std::uint32_t t : solid) facet->triangles.push_back(uv_of(t));
            builder_.add_facet(std::move(*facet), solid, figure);
        } else {
            for (std::uint32_t t : solid) builder_.add_triangle(t, uv_of(t), figure);
        }
    }

    std::optional<Facet> one_map(const std::vector<std::uint32_t>& solid) const {
        const auto by_area = [&](std::uint32_t a, std::uint32_t b) {
            const dvec3 m = builder_.surface().cross(a), n = builder_.surface().cross(b);
            return dot3(m, m) < dot3(n, n);
        };
        const std::uint32_t largest = *std::max_element(solid.begin(), solid.end(), by_area);
        std::optional<Facet> facet = facet_of(builder_.corners(largest), uv_of(largest));
        for (std::uint32_t t : solid) {
            const std::array<dvec3, 3> p = builder_.corners(t);
            const Triangle2 uv = uv_of(t);
            for (std::size_t k = 0; facet && k < 3; ++k) {
                const dvec2 off = facet->texel_of(p[k]) - uv[k];
                const bool same = std::abs(off.x) < 1e-3 && std::abs(off.y) < 1e-3 &&
                                  std::abs(dot3(facet->normal, p[k]) - facet->offset) <
                                      1e-6 * builder_.model.extent;
                if (!same) facet.reset();
            }
        }
        return facet;
    }

    ModelBuilder& builder_;
};

}  // namespace

void add_automatic(ModelBuilder& builder) {
    const std::vector<Chart> found = flat_charts(builder);
    const std::string& name = builder.object().name;
    for (std::size_t i = 0; i < found.size(); ++i)
        add_chart(builder, found[i], found.size() > 1 ? fmt::format("{} {}", name, i + 1) : name);
}

void add_given(ModelBuilder& builder) {
    check_st(builder);
    Given(builder).add();
}

}  // namespace gw::radiosity
