// Ray and triangle by Möller and Trumbore 1997, in double.
#include "multipass/polygon_planes.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

namespace gw::multipass {
namespace {

/// How well a ray goes through a triangle: the smallest of its barycentric coordinates.
struct Meeting {
    double inside = -std::numeric_limits<double>::infinity();
    SurfacePoint point;
};

Meeting meet_triangle(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& o, const dvec3& d) {
    const dvec3 e1 = b - a, e2 = c - a, p = cross3(d, e2);
    const double det = dot3(e1, p);
    if (det == 0) return {};
    const dvec3 s = o - a, q = cross3(s, e1);
    const double u = dot3(s, p) / det, v = dot3(d, q) / det, t = dot3(e2, q) / det;
    return {std::min({u, v, 1 - u - v}), {o + d * t, cross3(e1, e2)}};
}

std::vector<std::uint32_t> first_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> first(mesh.polygon_count() + 1, 0);
    for (const Triangle& t : mesh.triangles()) ++first[t.polygon + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    return first;
}

dvec3 to_world(const dmat4& m, const vec3& v) { return transform3(dmat3(m), dvec3(v)) + dvec3(m[3]); }

}  // namespace

PolygonTable::PolygonTable(const Model& model) : model_(&model), ids_(scene::polygon_ids(*model.scene)) {
    for (const Part& part : model.parts) first_triangle_.push_back(first_triangles(*part.object->mesh));
}

std::optional<SurfacePoint> PolygonTable::meet(std::uint32_t id, const dvec3& o, const dvec3& d) const {
    const auto polygon = scene::polygon_of(ids_, id);
    if (!polygon || polygon->polygon + 1 >= first_triangle_[polygon->object].size()) return std::nullopt;
    const scene::Object& placed = *model_->parts[polygon->object].object;
    const auto& first = first_triangle_[polygon->object];
    const auto triangles = placed.mesh->triangles();
    const auto& positions = placed.mesh->data().positions;
    Meeting best;
    for (std::uint32_t i = first[polygon->polygon]; i < first[polygon->polygon + 1]; ++i) {
        const auto at = [&](std::size_t k) {
            return to_world(placed.world_from_object, positions[triangles[i].vertex[k]]);
        };
        const Meeting m = meet_triangle(at(0), at(1), at(2), o, d);
        if (m.inside > best.inside) best = m;
    }
    if (best.inside == -std::numeric_limits<double>::infinity()) return std::nullopt;
    return best.point;
}

PixelRays::PixelRays(const scene::View& view)
    : world_from_clip_(glm::inverse(view.clip_from_eye * view.eye_from_world)),
      width_(view.width),
      height_(view.height) {}

PixelRay PixelRays::through(double x, double y) const {
    const auto at = [&](double z) {
        const dvec4 p = world_from_clip_ * dvec4(2 * x / width_ - 1, 2 * y / height_ - 1, z, 1);
        return dvec3(p) / p.w;
    };
    const dvec3 o = at(-1);
    return {o, at(1) - o};
}

}  // namespace gw::multipass
