// Families of random scenes of few polygons, so that a thousand of them are a quick test. Does not
// draw.
#pragma once

#include "tests/hiddensurface/families.h"

#include <cmath>

namespace gw::hiddensurface {

inline vec3 unit(const vec3& v) {
    const dvec3 d(v);
    return vec3(d / length(d));
}

/// A convex solid: a pyramid on both sides of a polygon, turned at random.
inline void add_solid(MeshData& data, const vec3& middle, Random& random) {
    const int sides = 3 + int(random(0, 4));
    vec3 axis = random_point(random, 1), across = random_point(random, 1);
    axis = unit(axis);
    across = unit(cross3(axis, across));
    const vec3 third = cross3(axis, across);
    const float radius = random(0.2, 0.45), up = random(0.1, 0.45), down = random(0.1, 0.45);
    const auto rim = [&](int k) {
        const double angle = 6.283185307179586 * k / sides;
        return middle + radius * (float(gw::cos(angle)) * across + float(gw::sin(angle)) * third);
    };
    for (int k = 0; k < sides; ++k) {
        for (const vec3& p : {rim(k), rim(k + 1), middle + up * axis}) data.positions.push_back(p);
        for (const vec3& p : {rim(k + 1), rim(k), middle - down * axis})
            data.positions.push_back(p);
    }
}

/// Convex solids that do not touch, one in each of some cells of a lattice.
inline scene::Scene convex_solids(std::uint32_t seed) {
    Random random(seed);
    MeshData data;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (random(0, 1) < 0.4 || (x == 0 && y == 0 && z == 0))
                    add_solid(data, vec3(float(x), float(y), float(z)) + random_point(random, 0.04),
                              random);
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera->eye = dvec3(random_point(random, 2)) + dvec3(0, 0, 6);
    scene.camera->fov = 30;
    return scene;
}

inline const std::vector<Family>& small_families() {
    static const std::vector<Family> all{
        {"convex solids", convex_solids, 1000},
        {"triangle soup",
         [](std::uint32_t seed) { return random_triangles(seed, 6 + int(seed % 10)); }},
        {"cyclic piles", cyclic_overlaps},
        {"piercing rectangles", piercing_rectangles},
        {"coplanar triangles", coplanar_triangles, 4},
        {"slivers", slivers},
        {"near plane crossings", near_plane_crossings},
    };
    return all;
}

}  // namespace gw::hiddensurface
