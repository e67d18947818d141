#include "raytrace/casting/casting.h"

#include "gw/stages/vertex.h"
#include "raytrace/casting/cast_methods.h"

#include <cmath>

namespace gw::raytrace {
namespace {

class BruteForce : public RayCaster {
public:
    explicit BruteForce(const ShapeTester& tester) : tester_(tester) {}

private:
    std::optional<CastHit> search(const Ray& ray, CastCounts& counts,
                                  std::vector<CastVisit>*) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        for (std::size_t i = 0; i < tester_.shapes().size(); ++i) tester_.test(ray, i, hit, counts);
        return hit;
    }

    ShapeTester tester_;
};

/// The corners of every polygon of a mesh.
std::vector<std::vector<std::uint32_t>> polygons_of(const Mesh& mesh) {
    const MeshData& data = mesh.data();
    std::vector<std::vector<std::uint32_t>> polygons;
    const auto corner = [&](std::size_t i) {
        return data.indices.empty() ? std::uint32_t(i) : data.indices[i];
    };
    if (data.primitive == Primitive::Quads || data.primitive == Primitive::Polygons) {
        std::size_t next = 0;
        for (std::uint32_t i = 0; i < mesh.polygon_count(); ++i) {
            const std::size_t all =
                data.indices.empty() ? data.positions.size() : data.indices.size();
            const std::size_t n = data.primitive == Primitive::Quads ? 4
                                  : data.polygon_sizes.empty()       ? all
                                                                     : data.polygon_sizes[i];
            polygons.emplace_back();
            for (std::size_t k = 0; k < n; ++k) polygons.back().push_back(corner(next + k));
            next += n;
        }
        return polygons;
    }
    for (const Triangle& t : mesh.triangles())
        polygons.push_back({t.vertex.begin(), t.vertex.end()});
    return polygons;
}

/// The radius of the sphere around the origin on which the mesh's vertices lie and whose normals
/// they have. None: there is no such sphere, or too few vertices.
std::optional<double> radius_of(const Mesh& mesh) {
    constexpr std::size_t fewest = 12;
    constexpr double rounding = 1e-5;
    const auto& p = mesh.data().positions;
    const auto& n = mesh.data().normals;
    if (p.size() < fewest || n.size() != p.size()) return std::nullopt;
    const double radius = length(dvec3(p[0]));
    for (std::size_t i = 0; i < p.size(); ++i) {
        const dvec3 away = dvec3(p[i]) - radius * normalized(dvec3(n[i]));
        if (!(dot3(away, away) <= rounding * rounding * radius * radius)) return std::nullopt;
    }
    return radius;
}

/// The object as a sphere, if it is one.
std::optional<Sphere> sphere_of(const scene::Object& object) {
    const dmat4& m = object.world_from_object;
    const double scale = dot3(dvec3(m[0]), dvec3(m[0]));
    for (int k = 1; k < 3; ++k)
        if (std::abs(dot3(dvec3(m[k]), dvec3(m[k])) - scale) > 1e-9 * scale) return std::nullopt;
    const auto radius = radius_of(*object.mesh);
    if (!radius) return std::nullopt;
    return Sphere{dvec3(m[3]), *radius * std::sqrt(scale)};
}

}  // namespace

Box box_of(const CastShape& s) {
    Box box;
    if (const auto* sphere = std::get_if<Sphere>(&s.shape)) {
        box.add(sphere->center - dvec3(sphere->radius));
        box.add(sphere->center + dvec3(sphere->radius));
    } else {
        for (const dvec3& p : std::get<PlanePolygon>(s.shape).corners) box.add(p);
    }
    return box;
}

void ShapeTester::test(const Ray& ray, std::size_t i, std::optional<CastHit>& nearest,
                       CastCounts& counts) const {
    ++counts.shapes;
    const auto* sphere = std::get_if<Sphere>(&shapes_[i].shape);
    const auto t = sphere ? intersect(ray, *sphere)
                          : intersect(ray, std::get<PlanePolygon>(shapes_[i].shape), test_);
    if (!t) return;
    if (!nearest || *t < nearest->t || (*t == nearest->t && i < nearest->shape))
        nearest = CastHit{i, *t};
}

std::vector<CastShape> cast_shapes(const scene::Scene& scene) {
    std::vector<CastShape> shapes;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        if (const auto sphere = sphere_of(object)) {
            shapes.push_back({*sphere, i});
            continue;
        }
        for (const auto& polygon : polygons_of(*object.mesh)) {
            std::vector<dvec3> corners;
            for (const std::uint32_t v : polygon)
                corners.push_back(dvec3(transform(
                    object.world_from_object, dvec4(dvec3(object.mesh->data().positions[v]), 1))));
            shapes.push_back({plane_polygon(std::move(corners)), i});
        }
    }
    return shapes;
}

std::unique_ptr<RayCaster> cast_by_brute_force(const ShapeTester& tester) {
    return std::make_unique<BruteForce>(tester);
}

std::unique_ptr<RayCaster> make_caster(CastMethod method, const std::vector<CastShape>& shapes,
                                       InsideTest test) {
    const ShapeTester tester(shapes, test);
    switch (method) {
        case CastMethod::BruteForce: return cast_by_brute_force(tester);
        case CastMethod::BoundingVolumes: return cast_by_volumes(tester);
        case CastMethod::Hierarchy: return cast_by_hierarchy(tester);
        case CastMethod::Grid: return cast_by_grid(tester);
    }
    return nullptr;
}

}  // namespace gw::raytrace
