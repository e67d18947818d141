#include "raytrace/surface.h"

#include "gw/vertex.h"
#include "scene/weights.h"

namespace gw::raytrace {
namespace {

dvec3 turned(const scene::View& view, const dvec3& v) { return transform3(dmat3(view.eye_from_world), v); }

}  // namespace

Surface surface(const scene::WorldTriangles& triangles, const scene::TrianglePoint& at,
                const dvec3& direction, const scene::View& view) {
    const scene::Weights w =
        scene::inside(scene::weights_at(triangles.corners(at.triangle), at.p, at.normal));
    Surface s{.at = at, .direction = direction};
    s.front = dot3(at.normal, direction) < 0;
    const double side = s.front ? 1 : -1;
    s.plane_normal = side * normalized(at.normal);
    s.normal = side * normalized(scene::mix(w, triangles.normals(at.triangle)));
    s.point.p = turned(view, at.p) + dvec3(view.eye_from_world[3]);
    s.point.n = turned(view, s.normal);
    s.point.to_eye = -turned(view, direction);
    s.point.st = scene::mix(w, triangles.texcoords(at.triangle));
    return s;
}

void add_footprint(Surface& surface, const scene::WorldTriangles& triangles, const Ray& beside,
                   const Ray& above) {
    const auto corner = triangles.corners(surface.at.triangle);
    const auto st = triangles.texcoords(surface.at.triangle);
    const auto change = [&](const Ray& ray) {
        return scene::mix(scene::weights_at(corner, ray.origin, ray.direction), st) - surface.point.st;
    };
    surface.point.st_dx = change(beside);
    surface.point.st_dy = change(above);
}

}  // namespace gw::raytrace
