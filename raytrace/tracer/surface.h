// The surface at a ray's hit: position, normals and texture coordinates. Does not shade.
#pragma once

#include "raytrace/ray.h"
#include "scene/draw/shading.h"
#include "scene/draw/view.h"
#include "scene/draw/world_triangles.h"

namespace gw::raytrace {

struct Surface {
    scene::SurfacePoint point;  ///< eye space, for eq. 3
    scene::TrianglePoint at;    ///< world space
    dvec3 direction{0};         ///< of the ray, length 1, world space
    /// of the triangle, length 1, on the side that is seen, world space
    dvec3 plane_normal{0};
    dvec3 normal{0};    ///< interpolated, length 1, on the side that is seen, world space
    bool front = true;  ///< the counter-clockwise side is seen
    /// Where rays leave the surface: the hit, or a point of the triangle next to it that is a little
    /// inside its border. A ray from outside the triangle would meet its neighbours wrongly.
    dvec3 start{0};
};

/// `direction` of length 1. The texture's footprint is left 0 (see add_footprint).
Surface surface(const scene::WorldTriangles& triangles, const scene::TrianglePoint& at,
                const dvec3& direction, const scene::View& view);

/// Sets the change of st to the rays of the next pixels, beside and above.
void add_footprint(Surface& surface, const scene::WorldTriangles& triangles, const Ray& beside,
                   const Ray& above);

}  // namespace gw::raytrace
