// Shadows by brute force: a ray through every pixel's centre, a ray from what it meets to the
// light. In double.
#pragma once

#include "scene/draw/view.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace gw::multipass {

struct WorldTriangle {
    dvec3 a, b, c;
    std::size_t object = 0;
};

inline std::vector<WorldTriangle> world_triangles(const scene::Scene& s) {
    std::vector<WorldTriangle> triangles;
    for (std::size_t i = 0; i < s.objects.size(); ++i) {
        const dmat4& m = s.objects[i].world_from_object;
        const auto& positions = s.objects[i].mesh->data().positions;
        const auto at = [&](std::uint32_t v) {
            return transform3(dmat3(m), dvec3(positions[v])) + dvec3(m[3]);
        };
        for (const Triangle& t : s.objects[i].mesh->triangles())
            triangles.push_back({at(t.vertex[0]), at(t.vertex[1]), at(t.vertex[2]), i});
    }
    return triangles;
}

/// Parameter of the ray o + t d in the triangle.
inline std::optional<double> hit(const dvec3& o, const dvec3& d, const WorldTriangle& t) {
    const dvec3 e1 = t.b - t.a, e2 = t.c - t.a, p = cross3(d, e2);
    const double det = dot3(e1, p);
    if (det == 0) return std::nullopt;
    const dvec3 s = o - t.a;
    const double u = dot3(s, p) / det;
    const dvec3 q = cross3(s, e1);
    const double v = dot3(d, q) / det;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    return dot3(e2, q) / det;
}

enum class Truth { Background, Lit, Dark, Edge };

/// Rays per pixel and direction; the middle one goes through the centre.
inline constexpr int rays = 3;

/// The point that a window position sees, through the inverse of the view's matrices.
inline dvec3 unproject(const dmat4& world_from_clip, const scene::View& view, double x, double y,
                       double z) {
    const dvec4 p = world_from_clip * dvec4(2 * x / view.width - 1, 2 * y / view.height - 1, z, 1);
    return dvec3(p) / p.w;
}

/// Per ray, bottom row first: whether light 0 arrives at what is surface. The dark side of a
/// surface is dark.
inline std::vector<Truth> true_shadows(const scene::Scene& s, const scene::View& view) {
    const auto triangles = world_triangles(s);
    const dmat4 world_from_clip = glm::inverse(view.clip_from_eye * view.eye_from_world);
    const scene::Light& light = s.lights.front();
    std::vector<Truth> result;
    for (int j = 0; j < rays * view.height; ++j)
        for (int i = 0; i < rays * view.width; ++i) {
            const double x = (i + 0.5) / rays, y = (j + 0.5) / rays;
            const dvec3 o = unproject(world_from_clip, view, x, y, -1);
            const dvec3 d = unproject(world_from_clip, view, x, y, 1) - o;
            double nearest = 1;
            const WorldTriangle* surface = nullptr;
            for (const WorldTriangle& t : triangles)
                if (const auto at = hit(o, d, t); at && *at > 0 && *at < nearest)
                    nearest = *at, surface = &t;
            if (!surface) {
                result.push_back(Truth::Background);
                continue;
            }
            const dvec3 p = o + d * nearest;
            const bool directional = light.kind == scene::LightKind::Directional;
            const dvec3 to_light =
                directional ? -dvec3(light.direction) : dvec3(light.position) - p;
            const dvec3 normal = cross3(surface->b - surface->a, surface->c - surface->a);
            bool dark = (dot3(normal, to_light) > 0) != (dot3(normal, d) < 0);
            for (const WorldTriangle& t : triangles) {
                const auto at = &t == surface ? std::nullopt : hit(p, to_light, t);
                dark = dark || (at && *at > 1e-6 && (directional || *at < 1));
            }
            result.push_back(dark ? Truth::Dark : Truth::Lit);
        }
    return result;
}

/// The truth of a pixel; Edge where it is not the same on all rays of the pixel and of its eight
/// neighbours.
inline Truth truth_at(const std::vector<Truth>& truth, int width, int height, int x, int y) {
    if (x < 1 || y < 1 || x > width - 2 || y > height - 2) return Truth::Edge;
    const auto at = [&](int i, int j) { return truth[std::size_t(j * width * rays + i)]; };
    for (int j = (y - 1) * rays; j < (y + 2) * rays; ++j)
        for (int i = (x - 1) * rays; i < (x + 2) * rays; ++i)
            if (at(i, j) != at(x * rays, y * rays)) return Truth::Edge;
    return at(x * rays, y * rays);
}

}  // namespace gw::multipass
