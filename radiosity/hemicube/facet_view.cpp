#include "radiosity/hemicube/facet_view.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

/// A convex polygon before a face: eye space with y and z up, along the view.
struct Polygon3 {
    std::array<dvec3, 12> p{};
    int n = 0;
};

/// The part with dot(plane, p) >= 0.
Polygon3 cut(const Polygon3& polygon, const dvec3& plane) {
    Polygon3 inside;
    for (int i = 0; i < polygon.n; ++i) {
        const dvec3 &a = polygon.p[std::size_t(i)],
                    &b = polygon.p[std::size_t(i + 1 < polygon.n ? i + 1 : 0)];
        const double da = dot3(plane, a), db = dot3(plane, b);
        if (da >= 0) inside.p[std::size_t(inside.n++)] = a;
        if ((da >= 0) != (db >= 0))
            inside.p[std::size_t(inside.n++)] = a + (b - a) * (da / (da - db));
    }
    return inside;
}

Polygon3 clipped(const Facet& facet, const scene::View& view, bool top) {
    Polygon3 polygon;
    for (int k = 0; k < facet.corner_count; ++k) {
        const dvec3 eye = transform3(dmat3(view.eye_from_world), facet.corners[std::size_t(k)]) +
                          dvec3(view.eye_from_world[3]);
        polygon.p[std::size_t(polygon.n++)] = {eye.x, eye.y, -eye.z};
    }
    // A frustum's sides meet in the eye, so they also clip the part behind it.
    for (const dvec3& plane :
         {dvec3(1, 0, 1), dvec3(-1, 0, 1), dvec3(0, -1, 1), dvec3(0, 1, top ? 1 : 0)})
        polygon = cut(polygon, plane);
    return polygon;
}

/// Whether the facet's sphere lies wholly beside the frustum.
bool beside(const Facet& facet, const scene::View& view, bool top) {
    const dvec3 eye =
        transform3(dmat3(view.eye_from_world), facet.center) + dvec3(view.eye_from_world[3]);
    // the sides have slope 1
    const double reach = facet.radius * 1.4142136, along = -eye.z + reach;
    return std::abs(eye.x) > along || eye.y > along || -eye.y > (top ? along : facet.radius);
}

}  // namespace

void find_region(const Facet& facet, const scene::View& view, bool top, Region& region) {
    region.spans.clear();
    if (beside(facet, view, top)) return;
    const Polygon3 polygon = clipped(facet, view, top);
    if (polygon.n < 3) return;
    const double half = view.width / 2.0;
    const int size = view.width, rows = top ? size : size / 2;
    std::array<dvec2, 12> pixel{};
    double low = rows, high = 0;
    for (std::size_t i = 0; i < std::size_t(polygon.n); ++i) {
        const dvec3& p = polygon.p[i];
        // the eye itself, on a facet's edge: far away, and clamped
        const double w = std::max(p.z, 1e-300);
        const auto on = [&](double v) { return std::clamp(v / w, -1.0, 1.0) * half; };
        pixel[i] = {on(p.x) + half, top ? on(p.y) + half : on(p.y)};
        low = std::min(low, pixel[i].y);
        high = std::max(high, pixel[i].y);
    }
    region.row = std::max(0, static_cast<int>(std::floor(low)) - 1);
    const int end = std::min(rows, static_cast<int>(std::floor(high)) + 2);
    for (int row = region.row; row < end; ++row) {
        double left = size, right = 0;
        for (std::size_t i = 0; i < std::size_t(polygon.n); ++i) {
            const dvec2 &a = pixel[i], &b = pixel[i + 1 < std::size_t(polygon.n) ? i + 1 : 0];
            const double bottom = row - 1, top_of_row = row + 2;
            if (std::max(a.y, b.y) < bottom || std::min(a.y, b.y) > top_of_row) continue;
            for (double y :
                 {std::clamp(a.y, bottom, top_of_row), std::clamp(b.y, bottom, top_of_row)}) {
                const double x = a.y == b.y ? a.x : a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
                left = std::min(left, x);
                right = std::max(right, x);
            }
            if (a.y == b.y) {
                left = std::min(left, b.x);
                right = std::max(right, b.x);
            }
        }
        region.spans.push_back({std::max(0, static_cast<int>(std::floor(left)) - 1),
                                std::min(size, static_cast<int>(std::floor(right)) + 2)});
    }
}

Homography homography(const Facet& facet, const Hemicube& hemicube, const scene::View& view,
                      int first_row) {
    const dmat4& m = view.eye_from_world;
    const dvec3 right(m[0].x, m[1].x, m[2].x), up(m[0].y, m[1].y, m[2].y),
        forward(-m[0].z, -m[1].z, -m[2].z);
    // A ray p = c + t d meets the plane at t = height / -(n d). So uv = (uv(c) (n d) - height grad
    // d) / (n d).
    const double height = dot3(facet.normal, hemicube.position) - facet.offset;
    const dvec2 uv = facet.texel_of(hemicube.position);
    const auto of_direction = [&](const dvec3& d) {
        const double w = dot3(facet.normal, d);
        return dvec3(uv.x * w - height * dot3(facet.grad_u, d),
                     uv.y * w - height * dot3(facet.grad_v, d), w);
    };
    const double step = 2.0 / view.width;
    const dvec3 corner = forward - right + (first_row * step - 1) * up;
    return {of_direction(corner), of_direction(step * right), of_direction(step * up)};
}

}  // namespace gw::radiosity
