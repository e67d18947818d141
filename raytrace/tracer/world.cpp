#include "raytrace/tracer/world.h"

#include <algorithm>
#include <cmath>

namespace gw::raytrace {
namespace {

/// Rounding of positions to float32, a few times.
constexpr double skin_of_size = 0x1p-20;

bool casts(const scene::Scene& scene, const scene::Object& object) {
    return object.casts_shadow && !(scene.materials[object.material].d < 1);
}

double size_of(const scene::Scene& scene) {
    const scene::Bounds b = scene::bounds(scene);
    double size = 0;
    for (int k = 0; k < 3; ++k) size = std::max({size, std::abs(b.low[k]), std::abs(b.high[k])});
    return size;
}

std::vector<HierarchyTriangle> casting_triangles(const scene::Scene& scene,
                                                 const scene::WorldTriangles& triangles,
                                                 const std::vector<HierarchyTriangle>& all) {
    std::vector<HierarchyTriangle> casting;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (casts(scene, scene.objects[triangles.object_of(i)])) casting.push_back(all[i]);
    return casting;
}

}  // namespace

std::vector<HierarchyTriangle> hierarchy_triangles(const scene::WorldTriangles& triangles) {
    std::vector<HierarchyTriangle> list(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto corner = triangles.corners(i);
        for (std::size_t c = 0; c < 3; ++c) list[i].corner[c] = vec3(corner[c]);
        list[i].polygon = triangles.id_of(i);
    }
    return list;
}

World::World(const scene::Scene& scene, int threads)
    : triangles_(scene), skin_(skin_of_size * size_of(scene)) {
    const std::vector<HierarchyTriangle> all = hierarchy_triangles(triangles_);
    all_ = Hierarchy(all, threads);
    if (!std::all_of(scene.objects.begin(), scene.objects.end(),
                     [&](const scene::Object& o) { return casts(scene, o); }))
        casting_ = Hierarchy(casting_triangles(scene, triangles_, all), threads);
}

HierarchyRay World::hierarchy_ray(const Ray& ray, double high, std::uint32_t from) const {
    const double length = std::sqrt(dot3(ray.direction, ray.direction));
    const double low = from == no_polygon ? 0 : skin_ / std::max(length, 1e-300);
    return {vec3(ray.origin), float(low), vec3(ray.direction), float(std::min(high, 3e38)), from};
}

std::optional<scene::TrianglePoint> World::nearest(const Ray& ray, double high,
                                                   std::uint32_t from) const {
    const auto hit = all_.nearest(hierarchy_ray(ray, high, from));
    if (!hit) return std::nullopt;
    const auto corner = triangles_.corners(hit->triangle);
    const dvec3 normal = cross3(corner[1] - corner[0], corner[2] - corner[0]);
    const double slope = dot3(normal, ray.direction);
    const double t = slope != 0 ? dot3(corner[0] - ray.origin, normal) / slope : double(hit->t);
    return scene::TrianglePoint{hit->triangle, point_at(ray, t), normal};
}

bool World::occluded(const Ray& ray, double high, std::uint32_t from) const {
    return (casting_ ? *casting_ : all_).occluded(hierarchy_ray(ray, high, from));
}

}  // namespace gw::raytrace
