#include "raytrace/tracer/surface.h"

#include "gw/stages/vertex.h"
#include "scene/draw/world_triangles.h"

#include <algorithm>

namespace gw::raytrace {
namespace {

/// A hit with a weight less than this is moved inwards before rays leave it.
constexpr double least_weight_inside = 0x1p-16;

dvec3 start_of(const std::array<dvec3, 3>& corner, const scene::Weights& weights) {
    scene::Weights moved = weights;
    for (double& w : moved) w = std::max(w, least_weight_inside);
    return scene::mix(scene::inside(moved), corner);
}

}  // namespace

Surface surface(const scene::WorldTriangles& triangles, const scene::TrianglePoint& at,
                const dvec3& direction, const scene::View& view) {
    const std::array<dvec3, 3> corner = triangles.corners(at.triangle);
    const scene::Weights met = scene::weights_at(corner, at.p, at.normal), w = scene::inside(met);
    const bool front = dot3(at.normal, direction) < 0;
    const double side = front ? 1 : -1;
    const dvec3 normal = side * normalized(scene::mix(w, triangles.normals(at.triangle)));
    const dmat3 turn(view.eye_from_world);
    return {.point = {.p = transform3(turn, at.p) + dvec3(view.eye_from_world[3]),
                      .n = transform3(turn, normal),
                      .to_eye = -transform3(turn, direction),
                      .st = scene::mix(w, triangles.texcoords(at.triangle))},
            .at = at,
            .direction = direction,
            .plane_normal = side * normalized(at.normal),
            .normal = normal,
            .front = front,
            .start = start_of(corner, met)};
}

void add_footprint(Surface& surface, const scene::WorldTriangles& triangles, const Ray& beside,
                   const Ray& above) {
    const auto corner = triangles.corners(surface.at.triangle);
    const auto st = triangles.texcoords(surface.at.triangle);
    const auto change = [&](const Ray& ray) {
        return scene::mix(scene::weights_at(corner, ray.origin, ray.direction), st) -
               surface.point.st;
    };
    surface.point.st_dx = change(beside);
    surface.point.st_dy = change(above);
}

}  // namespace gw::raytrace
