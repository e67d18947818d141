// Ray and triangle by Möller and Trumbore 1997, in double.
#include "scene/world_triangles.h"

#include "gw/vertex.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

namespace gw::scene {
namespace {

/// How well a ray goes through a triangle: the smallest of its barycentric coordinates.
struct Meeting {
    double inside = -std::numeric_limits<double>::infinity();
    TrianglePoint point;
};

Meeting meet_triangle(const std::array<dvec3, 3>& corner, const dvec3& o, const dvec3& d) {
    const dvec3 e1 = corner[1] - corner[0], e2 = corner[2] - corner[0], p = cross3(d, e2);
    const double det = dot3(e1, p);
    if (det == 0) return {};
    const dvec3 s = o - corner[0], q = cross3(s, e1);
    const double u = dot3(s, p) / det, v = dot3(d, q) / det, t = dot3(e2, q) / det;
    return {std::min({u, v, 1 - u - v}), {0, o + d * t, cross3(e1, e2)}};
}

dvec3 to_world(const dmat4& m, const vec3& v) { return transform3(dmat3(m), dvec3(v)) + dvec3(m[3]); }

std::vector<dvec3> world_normals(const Object& object) {
    const dmat3 m = glm::transpose(glm::inverse(dmat3(object.world_from_object)));
    std::vector<dvec3> normals;
    for (const vec3& n : object.mesh->data().normals) normals.push_back(normalized(transform3(m, dvec3(n))));
    return normals;
}

}  // namespace

WorldTriangles::WorldTriangles(const Scene& scene) {
    const PolygonIds ids = polygon_ids(scene);
    first_.assign(std::size_t(ids.end) + 1, 0);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        Placed placed{object.mesh, size(), {}, world_normals(object)};
        for (const vec3& p : object.mesh->data().positions)
            placed.positions.push_back(to_world(object.world_from_object, p));
        for (const Triangle& t : object.mesh->triangles()) {
            const std::uint32_t id = ids.first[i] + t.polygon;
            places_.push_back({static_cast<std::uint32_t>(i), id});
            ++first_[id + 1];
        }
        objects_.push_back(std::move(placed));
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

const Triangle& WorldTriangles::in_mesh(std::uint32_t triangle) const {
    const Placed& object = objects_[object_of(triangle)];
    return object.mesh->triangles()[triangle - object.first];
}

std::array<dvec3, 3> WorldTriangles::corners(std::uint32_t triangle) const {
    const auto& p = objects_[object_of(triangle)].positions;
    const auto& v = in_mesh(triangle).vertex;
    return {p[v[0]], p[v[1]], p[v[2]]};
}

std::array<dvec3, 3> WorldTriangles::normals(std::uint32_t triangle) const {
    const auto& n = objects_[object_of(triangle)].normals;
    const auto& v = in_mesh(triangle).vertex;
    if (!n.empty()) return {n[v[0]], n[v[1]], n[v[2]]};
    const auto corner = corners(triangle);
    const dvec3 plane = normalized(cross3(corner[1] - corner[0], corner[2] - corner[0]));
    return {plane, plane, plane};
}

std::array<dvec2, 3> WorldTriangles::texcoords(std::uint32_t triangle) const {
    const auto& st = objects_[object_of(triangle)].mesh->data().texcoords;
    const auto& v = in_mesh(triangle).vertex;
    if (st.empty()) return {};
    return {dvec2(st[v[0]]), dvec2(st[v[1]]), dvec2(st[v[2]])};
}

std::optional<TrianglePoint> WorldTriangles::meet(std::uint32_t id, const dvec3& o, const dvec3& d) const {
    if (std::size_t(id) + 1 >= first_.size()) return std::nullopt;
    Meeting best;
    for (std::uint32_t i = first_[id]; i < first_[id + 1]; ++i) {
        Meeting m = meet_triangle(corners(i), o, d);
        m.point.triangle = i;
        if (m.inside > best.inside) best = m;
    }
    if (best.inside == -std::numeric_limits<double>::infinity()) return std::nullopt;
    return best.point;
}

}  // namespace gw::scene
