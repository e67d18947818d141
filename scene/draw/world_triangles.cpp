// Ray and triangle by Möller and Trumbore 1997, in double.
#include "scene/draw/world_triangles.h"

#include "gw/stages/vertex.h"

#include <glm/matrix.hpp>

#include <limits>

namespace gw::scene {
namespace {

/// How well a ray goes through a triangle: the smallest of its barycentric coordinates.
struct TriangleHit {
    double inside = -std::numeric_limits<double>::infinity();
    TrianglePoint point;
};

TriangleHit meet_triangle(const std::array<dvec3, 3>& corner, const dvec3& o, const dvec3& d) {
    const dvec3 e1 = corner[1] - corner[0], e2 = corner[2] - corner[0], p = cross3(d, e2);
    const double det = dot3(e1, p);
    if (det == 0) return {};
    const dvec3 s = o - corner[0], q = cross3(s, e1);
    const double u = dot3(s, p) / det, v = dot3(d, q) / det, t = dot3(e2, q) / det;
    return {std::min({u, v, 1 - u - v}), {0, o + d * t, cross3(e1, e2)}};
}

dvec3 to_world(const dmat4& m, const vec3& v) {
    return transform3(dmat3(m), dvec3(v)) + dvec3(m[3]);
}

}  // namespace

void WorldTriangles::add_vertices(const Object& object) {
    const MeshData& mesh = object.mesh->data();
    const dmat3 m = glm::transpose(glm::inverse(dmat3(object.world_from_object)));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        PlacedVertex& v = vertices_.emplace_back();
        v.p = to_world(object.world_from_object, mesh.positions[i]);
        if (!mesh.normals.empty()) v.n = normalized(transform3(m, dvec3(mesh.normals[i])));
        if (!mesh.texcoords.empty()) v.st = mesh.texcoords[i];
    }
}

WorldTriangles::WorldTriangles(const Scene& scene) {
    const PolygonIds ids = polygon_ids(scene);
    first_.assign(std::size_t(ids.end) + 1, 0);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto vertex = static_cast<std::uint32_t>(vertices_.size());
        has_normals_.push_back(!object.mesh->data().normals.empty());
        add_vertices(object);
        for (const Triangle& t : object.mesh->triangles()) {
            const std::uint32_t id = ids.first[i] + t.polygon;
            places_.push_back({static_cast<std::uint32_t>(i),
                               id,
                               {vertex + t.vertex[0], vertex + t.vertex[1], vertex + t.vertex[2]}});
            ++first_[id + 1];
        }
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

std::array<dvec3, 3> WorldTriangles::plane_normals(std::uint32_t triangle) const {
    const auto corner = corners(triangle);
    const dvec3 plane = normalized(cross3(corner[1] - corner[0], corner[2] - corner[0]));
    return {plane, plane, plane};
}

std::optional<TrianglePoint> WorldTriangles::meet(std::uint32_t id, const dvec3& o,
                                                  const dvec3& d) const {
    if (std::size_t(id) + 1 >= first_.size()) return std::nullopt;
    TriangleHit best;
    for (std::uint32_t i = first_[id]; i < first_[id + 1]; ++i) {
        TriangleHit m = meet_triangle(corners(i), o, d);
        m.point.triangle = i;
        if (m.inside > best.inside) best = m;
    }
    if (best.inside == -std::numeric_limits<double>::infinity()) return std::nullopt;
    return best.point;
}

}  // namespace gw::scene
