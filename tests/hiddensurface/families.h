// Families of random scenes, one for each way in which polygons hide each other. Does not draw.
#pragma once

#include "gw/base/elementary.h"
#include "tests/hiddensurface/cases.h"

#include <functional>

namespace gw::hiddensurface {

struct Family {
    const char* name;
    std::function<scene::Scene(std::uint32_t seed)> scene;
    /// The snap turns over at most one pixel in so many. Less where surfaces lie in or on each
    /// other.
    std::uint64_t snapped_one_in = 10000;
    bool defeats_sorting = true;  ///< else one distance each is (almost) enough
};

inline vec3 random_point(Random& random, double reach) {
    const float x = random(-reach, reach), y = random(-reach, reach), z = random(-reach, reach);
    return {x, y, z};
}

/// A parallelogram as a polygon of four corners.
inline void add_parallelogram(MeshData& data, const vec3& corner, const vec3& u, const vec3& v) {
    for (const vec3& p : {corner, corner + u, corner + u + v, corner + v})
        data.positions.push_back(p);
}

/// Bars around an axis, each over the next: rings without an order.
inline scene::Scene cyclic_overlaps(std::uint32_t seed) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    for (int ring = 0; ring < 3; ++ring) {
        const int bars = 3 + int(random(0, 4));
        const vec3 middle = random_vector(random, 1, 0.8, 1);
        const double slope = random(0.1, 0.8);
        for (int k = 0; k < bars; ++k) {
            const double angle = 6.283185307179586 * k / bars;
            const vec3 out(float(gw::cos(angle)), float(gw::sin(angle)), 0),
                along(-out.y, out.x, float(slope));
            add_parallelogram(data, middle + 0.4f * out - along, 2.0f * along, 0.2f * out);
        }
    }
    return polygon_scene(std::move(data));
}

/// Rectangles through points near the middle.
inline scene::Scene piercing_rectangles(std::uint32_t seed) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i < 10; ++i) {
        const vec3 u = random_point(random, 2.5), v = random_point(random, 2.5);
        add_parallelogram(data, random_point(random, 0.3) - 0.5f * (u + v), u, v);
    }
    return polygon_scene(std::move(data));
}

/// Triangles in a few planes, overlapping in each: true ties of depth.
inline scene::Scene coplanar_triangles(std::uint32_t seed) {
    Random random(seed);
    MeshData data;
    for (int plane = 0; plane < 3; ++plane) {
        const vec3 origin = random_point(random, 0.8), u = random_point(random, 1),
                   v = random_point(random, 1);
        for (int i = 0; i < 8 * 3; ++i) {
            const float a = random(-1.5, 1.5), b = random(-1.5, 1.5);
            data.positions.push_back(origin + a * u + b * v);
        }
    }
    return polygon_scene(std::move(data));
}

/// Needles a pixel wide and less.
inline scene::Scene slivers(std::uint32_t seed) {
    Random random(seed);
    MeshData data;
    for (int i = 0; i < 60; ++i) {
        const vec3 p = random_point(random, 1.5), along = random_point(random, 2);
        for (const vec3& corner : {p, p + along, p + 0.5f * along + random_point(random, 0.03)})
            data.positions.push_back(corner);
    }
    return polygon_scene(std::move(data));
}

/// Triangles around the eye, most of them cut by the near plane.
inline scene::Scene near_plane_crossings(std::uint32_t seed) {
    scene::Scene scene = random_triangles(seed, 40);
    scene.camera->eye = {0, 0, 0.3};
    scene.camera->at = {0, 0, -1};
    scene.camera->fov = 80;
    return scene;
}

/// A surface of connected quadrilaterals, none plane, seen at a grazing angle.
inline scene::Scene grazing_mesh(std::uint32_t seed) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    constexpr int n = 12;
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k)
            data.positions.push_back(
                vec3(float(i) / 3 - 2, random(-0.25, 0.25) - 0.5f, float(k) / 3 - 2));
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t first = i * (n + 1) + k;
            for (const std::uint32_t corner : {first, first + 1, first + n + 2, first + n + 1})
                data.indices.push_back(corner);
        }
    return polygon_scene(std::move(data));
}

/// Large sheets one close above the other, seen at a grazing angle.
inline scene::Scene grazing_sheets(std::uint32_t seed) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i < 12; ++i) {
        const double depth = random(1, 3), width = random(1, 3);
        const double z = random(-3, 0), y = random(-0.6, -0.5), x = random(-3, 0);
        add_parallelogram(data, vec3(x, y, z), vec3(width, 0, 0), vec3(0, 0, depth));
    }
    return polygon_scene(std::move(data));
}

/// Blocks that touch: faces in one plane, corners on edges.
inline scene::Scene touching_blocks(std::uint32_t seed) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i < 8; ++i) {
        const auto step = [&](int low, int high) {
            return float(low + int(random(0, high - low))) / 2;
        };
        const float c = step(-3, 3), b = step(-3, 3), a = step(-3, 3);
        const float depth = step(1, 4), height = step(1, 4), width = step(1, 4);
        const vec3 p(a, b, c), size(width, height, depth);
        const vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
        add_parallelogram(data, p, y, x);
        add_parallelogram(data, p + z, x, y);
        add_parallelogram(data, p, x, z);
        add_parallelogram(data, p + y, z, x);
        add_parallelogram(data, p, z, y);
        add_parallelogram(data, p + x, y, z);
    }
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera->eye = {3, 4, 5};
    return scene;
}

inline const std::vector<Family>& families() {
    static const std::vector<Family> all{
        {"triangle soup",
         [](std::uint32_t seed) { return random_triangles(seed, 10 + int(seed % 12) * 5); }},
        {"cyclic overlaps", cyclic_overlaps},
        {"piercing rectangles", piercing_rectangles},
        {"coplanar triangles", coplanar_triangles, 4},
        {"slivers", slivers, 10000, false},
        {"near plane crossings", near_plane_crossings},
        {"grazing mesh", grazing_mesh, 10000, false},
        {"grazing sheets", grazing_sheets, 50},
        {"touching blocks", touching_blocks, 50},
        {"layers", [](std::uint32_t seed) { return random_layers(seed, 16); }, 10000, false},
    };
    return all;
}

}  // namespace gw::hiddensurface
