// All triangles of a scene in world space, numbered object by object, polygon by polygon. Rays and
// the identifiers of an item buffer [K4i] refer to them. Also barycentric weights in a triangle.
// Does not search (raytrace/ does).
#pragma once

#include "gw/base/types.h"
#include "scene/draw/draw_commands.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace gw::scene {

/// Where a ray o + t d meets the plane of a triangle.
struct TrianglePoint {
    std::uint32_t triangle = 0;
    dvec3 p{0};
    dvec3 normal{0};  ///< of the plane, counter-clockwise from outside; of any length
    bool operator==(const TrianglePoint&) const = default;
};

class WorldTriangles {
public:
    explicit WorldTriangles(const Scene& scene);

    std::uint32_t size() const { return static_cast<std::uint32_t>(places_.size()); }
    std::uint32_t object_of(std::uint32_t triangle) const { return places_[triangle].object; }
    /// The identifier of its polygon: polygon_ids of scene/draw/draw_commands.h, of meshes numbered
    /// without gaps.
    std::uint32_t id_of(std::uint32_t triangle) const { return places_[triangle].id; }
    /// The first triangle of a polygon; none: no triangle has this identifier.
    std::optional<std::uint32_t> first_of(std::uint32_t id) const {
        if (std::size_t(id) + 1 >= first_.size() || first_[id] == first_[id + 1])
            return std::nullopt;
        return first_[id];
    }

    std::array<dvec3, 3> corners(std::uint32_t triangle) const {
        const auto& v = places_[triangle].vertex;
        return {vertices_[v[0]].p, vertices_[v[1]].p, vertices_[v[2]].p};
    }
    /// Normals of length 1, or 0; the plane's if the mesh has none.
    std::array<dvec3, 3> normals(std::uint32_t triangle) const {
        const auto& v = places_[triangle].vertex;
        if (!has_normals_[object_of(triangle)]) return plane_normals(triangle);
        return {vertices_[v[0]].n, vertices_[v[1]].n, vertices_[v[2]].n};
    }
    /// 0 if the mesh has none.
    std::array<dvec2, 3> texcoords(std::uint32_t triangle) const {
        const auto& v = places_[triangle].vertex;
        return {dvec2(vertices_[v[0]].st), dvec2(vertices_[v[1]].st), dvec2(vertices_[v[2]].st)};
    }

    /// The point of polygon `id` that the ray sees, on the plane of the triangle that the ray
    /// passes through or least misses: a fragment's centre lies in the snapped triangle, up to a
    /// sixteenth of a pixel beside the true one. None if no polygon has this identifier, or the
    /// ray is parallel to it.
    std::optional<TrianglePoint> meet(std::uint32_t id, const dvec3& o, const dvec3& d) const;

private:
    struct Place {
        std::uint32_t object = 0, id = 0;
        std::array<std::uint32_t, 3> vertex{};  ///< of all objects' vertices, numbered through
    };
    void add_vertices(const Object& object);
    std::array<dvec3, 3> plane_normals(std::uint32_t triangle) const;

    /// World space. One cache line, since a ray test reads all of it.
    struct alignas(64) PlacedVertex {
        dvec3 p{0}, n{0};  ///< n: 0 if the mesh has no normals
        vec2 st{0};
    };

    std::vector<bool> has_normals_;  ///< by object
    std::vector<Place> places_;      ///< by triangle
    std::vector<PlacedVertex> vertices_;
    std::vector<std::uint32_t> first_;  ///< triangle of each identifier; one more at the end
};

/// The barycentric weights of three corners; they sum to 1.
using Weights = std::array<double, 3>;

/// Weights of the point at which the line origin + t direction meets the triangle's plane; the
/// first corner's if they are parallel, or the triangle has no area.
inline Weights weights_at(const std::array<dvec3, 3>& corner, const dvec3& origin,
                          const dvec3& direction) {
    const dvec3 u = corner[1] - corner[0], v = corner[2] - corner[0], n = cross3(u, v);
    const double slope = dot3(n, direction), size = dot3(n, n);
    if (slope == 0 || size == 0) return {1, 0, 0};
    const dvec3 d = origin + (dot3(n, corner[0] - origin) / slope) * direction - corner[0];
    const double b = dot3(cross3(d, v), n) / size, c = dot3(cross3(u, d), n) / size;
    return {1 - b - c, b, c};
}

/// Approximately the nearest point of the triangle: negative weights become 0.
inline Weights inside(Weights w) {
    double sum = 0;
    for (double& value : w) sum += value = std::max(value, 0.0);
    for (double& value : w) value /= sum;
    return w;
}

template <class Vector>
Vector mix(const Weights& w, const std::array<Vector, 3>& v) {
    return w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
}

}  // namespace gw::scene
