#include "radiosity/model/facet.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
Facet facet_along(const dvec3& origin, const dvec3& du, const dvec3& dv, const dvec3& normal) {
    Facet facet;
    facet.normal = normal;
    facet.offset = dot3(normal, origin);
    facet.origin = origin;
    facet.du = du;
    facet.dv = dv;
    const dvec3 to_u = cross3(dv, normal), to_v = cross3(du, normal);
    facet.grad_u = to_u / dot3(du, to_u);
    facet.grad_v = to_v / dot3(dv, to_v);
    facet.texel_area = length(cross3(du, dv));
    return facet;
}

std::optional<Facet> facet_of(const std::array<dvec3, 3>& p, const std::array<dvec2, 3>& uv) {
    const dvec3 e = p[1] - p[0], f = p[2] - p[0], cross = cross3(e, f);
    const dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double det = a.x * b.y - a.y * b.x, twice_area = length(cross);
    const double size =
        std::max(std::max(std::abs(a.x), std::abs(a.y)), std::max(std::abs(b.x), std::abs(b.y)));
    if (!(std::abs(det) > 1e-9 * size * size) || !(twice_area > 0)) return std::nullopt;
    const dvec3 du = (e * b.y - f * a.y) / det, dv = (f * a.x - e * b.x) / det;
    return facet_along(p[0] - (uv[0].x * du + uv[0].y * dv), du, dv, cross / twice_area);
}

void finish(Facet& facet) {
    // Rounding must not lead out of the pixmap.
    for (Triangle2& t : facet.triangles)
        for (dvec2& uv : t) uv = {std::max(uv.x, 0.0), std::max(uv.y, 0.0)};
    facet.low = facet.high = facet.triangles.front()[0];
    for (const Triangle2& t : facet.triangles)
        for (const dvec2& uv : t) {
            facet.low = {std::min(facet.low.x, uv.x), std::min(facet.low.y, uv.y)};
            facet.high = {std::max(facet.high.x, uv.x), std::max(facet.high.y, uv.y)};
        }
    if (facet.triangles.size() == 1) {
        facet.corner_count = 3;
        for (std::size_t k = 0; k < 3; ++k) facet.corners[k] = facet.at(facet.triangles[0][k]);
    } else {
        facet.corner_count = 4;
        facet.corners = {facet.at(facet.low), facet.at({facet.high.x, facet.low.y}),
                         facet.at(facet.high), facet.at({facet.low.x, facet.high.y})};
    }
    facet.center = facet.at((facet.low + facet.high) / 2.0);
    for (int k = 0; k < facet.corner_count; ++k)
        facet.radius = std::max(facet.radius, length(facet.corners[std::size_t(k)] - facet.center));
}

}  // namespace gw::radiosity
