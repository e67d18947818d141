#include "radiosity/hemicube/homography.h"

namespace gw::radiosity {

Homography homography(const Facet& facet, const Hemicube& hemicube, const scene::View& view,
                      int first_row) {
    const dmat4& m = view.eye_from_world;
    const dvec3 right(m[0].x, m[1].x, m[2].x), up(m[0].y, m[1].y, m[2].y),
        forward(-m[0].z, -m[1].z, -m[2].z);
    // A ray p = c + t d meets the plane at t = height / -(n d): uv = (uv(c) (n d) - height grad d)
    // / (n d).
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
