#include "raytrace/tracer/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gw::raytrace {
namespace {

// Lengths as parts of the largest coordinate.
/// Rounding of positions in double: planes this near to a ray's start pass through it.
constexpr double on_plane = 0x1p-44;
/// Triangles this near to each other, in the same plane, are coincident: the first one is met.
constexpr double coincident = 0x1p-38;
/// Rounding of a start to float32.
constexpr double behind_start = 0x1p-20;

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

/// A triangle that a ray meets.
struct Met {
    double t = 0;
    dvec3 normal{0};
    std::uint32_t triangle = no_triangle;
};

bool same_plane(const dvec3& m, const dvec3& n) {
    const dvec3 c = cross3(m, n);
    return dot3(c, c) <= 1e-18 * dot3(m, m) * dot3(n, n);
}

/// Tests triangles in double and keeps the nearest, with all triangles that are as near.
class NearestTest : public TriangleTest {
public:
    NearestTest(const scene::WorldTriangles& triangles, const Ray& ray, double high, double size,
                std::uint32_t from)
        : triangles_(triangles),
          ray_(ray),
          high_(high),
          nearest_plane_(from == no_triangle ? 0 : on_plane * size),
          tie_(coincident * std::max(size, length(ray.origin)) /
               std::max(length(ray.direction), 1e-300)) {}

    float test(std::uint32_t number) override {
        if (const Met met = meet(number); met.triangle != no_triangle) add(met);
        const double high = nearest_.empty() ? high_ : t_ + tie_;
        return float(std::min(high * (1 + 0x1p-22), 3e38));
    }

    bool found() const { return !nearest_.empty(); }
    /// The first triangle of the nearest; none: the ray only grazes them. A ray that meets an edge
    /// between a front and a back enters and leaves at once: so it passes by.
    Met result() const {
        for (const Met& met : nearest_)
            if (std::none_of(nearest_.begin(), nearest_.end(),
                             [&](const Met& other) { return turns_away(met, other); }))
                return met;
        return {};
    }
    /// Goes on behind the nearest.
    void pass() {
        low_ = t_ + tie_;
        nearest_.clear();
    }

private:
    /// Neighbours that share a side leave no gap: the side's edge function is the same for both but
    /// for its sign. A triangle whose plane passes through the ray's start is not met.
    Met meet(std::uint32_t number) const {
        const auto corner = triangles_.corners(number);
        const dvec3 a = corner[0] - ray_.origin, b = corner[1] - ray_.origin,
                    c = corner[2] - ray_.origin;
        const double u = dot3(cross3(b, c), ray_.direction), v = dot3(cross3(c, a), ray_.direction),
                     w = dot3(cross3(a, b), ray_.direction);
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
        const dvec3 normal = cross3(corner[1] - corner[0], corner[2] - corner[0]);
        const double slope = dot3(normal, ray_.direction), height = dot3(normal, a);
        if (slope == 0 || std::abs(height) < nearest_plane_ * length(normal)) return {};
        const double t = height / slope;
        if (!(t > low_ && t < high_)) return {};
        return {t, normal, number};
    }

    void add(const Met& met) {
        if (!nearest_.empty() && met.t > t_ + tie_) return;
        if (nearest_.empty() || met.t < t_) t_ = met.t;
        nearest_.push_back(met);
        std::erase_if(nearest_, [&](const Met& m) { return m.t > t_ + tie_; });
        std::sort(nearest_.begin(), nearest_.end(),
                  [](const Met& m, const Met& n) { return m.triangle < n.triangle; });
    }

    bool turns_away(const Met& m, const Met& n) const {
        return triangles_.object_of(m.triangle) == triangles_.object_of(n.triangle) &&
               (dot3(m.normal, ray_.direction) < 0) != (dot3(n.normal, ray_.direction) < 0) &&
               !same_plane(m.normal, n.normal);
    }

    const scene::WorldTriangles& triangles_;
    const Ray& ray_;
    double low_ = 0, high_;
    double nearest_plane_, tie_;
    double t_ = 0;              ///< of the nearest
    std::vector<Met> nearest_;  ///< in the order of their numbers
};

/// The ray for the hierarchy, which begins a little before its start.
HierarchyRay rounded(const Ray& ray, double high, double size, std::uint32_t from) {
    const double low = -behind_start * size / std::max(length(ray.direction), 1e-300);
    return {vec3(ray.origin), float(low), vec3(ray.direction), float(std::min(high, 3e38)), from};
}

}  // namespace

std::vector<HierarchyTriangle> hierarchy_triangles(const scene::WorldTriangles& triangles) {
    std::vector<HierarchyTriangle> list(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto corner = triangles.corners(i);
        for (std::size_t c = 0; c < 3; ++c) list[i].corner[c] = vec3(corner[c]);
        list[i].number = i;
    }
    return list;
}

World::World(const scene::Scene& scene, int threads) : triangles_(scene), size_(size_of(scene)) {
    const std::vector<HierarchyTriangle> all = hierarchy_triangles(triangles_);
    all_ = Hierarchy(all, threads);
    if (!std::all_of(scene.objects.begin(), scene.objects.end(),
                     [&](const scene::Object& o) { return casts(scene, o); }))
        casting_ = Hierarchy(casting_triangles(scene, triangles_, all), threads);
}

std::optional<scene::TrianglePoint> World::nearest(const Ray& ray, double high,
                                                   std::uint32_t from) const {
    NearestTest test(triangles_, ray, high, size_, from);
    for (;;) {
        all_.find(rounded(ray, high, size_, from), test);
        if (!test.found()) return std::nullopt;
        const Met met = test.result();
        if (met.triangle != no_triangle)
            return scene::TrianglePoint{met.triangle, point_at(ray, met.t), met.normal};
        test.pass();
    }
}

bool World::occluded(const Ray& ray, double high, std::uint32_t from) const {
    NearestTest test(triangles_, ray, high, size_, from);
    const Hierarchy& hierarchy = casting_ ? *casting_ : all_;
    hierarchy.find(rounded(ray, high, size_, from), test);
    return test.found();
}

}  // namespace gw::raytrace
