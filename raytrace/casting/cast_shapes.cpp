// Meshes as the polygons, and spheres, that the lecture's rays meet.
#include "gw/stages/vertex.h"
#include "raytrace/casting/casting.h"

#include <cmath>

namespace gw::raytrace {
namespace {

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

/// The radius of the sphere around the origin that the mesh stands for: its vertices lie on it, and
/// have its normals. None: it does not, or has too few vertices to say so.
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

/// The object as a sphere, where it is one.
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

}  // namespace gw::raytrace
