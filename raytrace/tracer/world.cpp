#include "raytrace/tracer/world.h"

#include "raytrace/tracer/crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gw::raytrace {
namespace {

// Lengths as parts of the largest coordinate.
/// Planes this near to a ray's start pass through it: four times the rounding of a start. Neighbours
/// with an angle of 1e-7 are not much farther away.
constexpr double on_plane = 0x1p-48;
/// Triangles this near to each other, in the same plane, are coincident: the first one is met.
constexpr double coincident = 0x1p-38;
/// Rounding of a start to float32.
constexpr double behind_start = 0x1p-20;

bool casts(const scene::Scene& scene, const scene::Object& object) {
    return object.casts_shadow && !(scene.materials[object.material].d < 1);
}

std::vector<bool> single_sided(const scene::Scene& scene) {
    std::vector<bool> list;
    for (const scene::Object& object : scene.objects) list.push_back(object.single_sided);
    if (std::ranges::find(list, true) == list.end()) list.clear();
    return list;
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
    NearestTest(const scene::WorldTriangles& triangles, const std::vector<bool>& single_sided,
                const Ray& ray, double high, double size, std::uint32_t from)
        : triangles_(triangles),
          single_sided_(single_sided),
          ray_(ray),
          crossing_(ray, size),
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
    /// The first triangle of the nearest; none: the ray only grazes them. A ray that meets a front
    /// and a back at once enters and leaves: so it passes by.
    Met result() const {
        const auto met = std::find_if_not(nearest_.begin(), nearest_.end(),
                                          [&](const Met& m) { return is_undone(m); });
        return met == nearest_.end() ? Met{} : *met;
    }
    /// Goes on behind the nearest.
    void pass() {
        low_ = t_ + tie_;
        nearest_.clear();
    }

private:
    /// A triangle whose plane passes through the ray's start is not met.
    Met meet(std::uint32_t number) const {
        const auto at = crossing_.cross(triangles_.corners(number));
        if (!at || !(at->t > low_ && at->t < high_)) return {};
        if (std::abs(at->height) < nearest_plane_ * length(at->normal)) return {};
        const bool back = dot3(at->normal, ray_.direction) > 0;
        if (back && !single_sided_.empty() && single_sided_[triangles_.object_of(number)])
            return {};
        return {at->t, at->normal, number};
    }

    void add(const Met& met) {
        if (!nearest_.empty() && met.t > t_ + tie_) return;
        if (nearest_.empty() || met.t < t_) t_ = met.t;
        nearest_.push_back(met);
        std::erase_if(nearest_, [&](const Met& m) { return m.t > t_ + tie_; });
        std::sort(nearest_.begin(), nearest_.end(),
                  [](const Met& m, const Met& n) { return m.triangle < n.triangle; });
    }

    int facing(const Met& met) const { return dot3(met.normal, ray_.direction) < 0 ? 1 : -1; }

    /// Of triangles of its object as near as this one, the ray passes as many fronts as backs, or
    /// more of the other kind. Coincident triangles do not count: a sheet with two sides.
    bool is_undone(const Met& met) const {
        int facing_alike = 0;
        bool turns = false;
        for (const Met& other : nearest_) {
            if (triangles_.object_of(other.triangle) != triangles_.object_of(met.triangle))
                continue;
            facing_alike += facing(met) * facing(other);
            turns = turns || !same_plane(met.normal, other.normal);
        }
        return turns && facing_alike <= 0;
    }

    const scene::WorldTriangles& triangles_;
    const std::vector<bool>& single_sided_;
    const Ray& ray_;
    CrossingTest crossing_;
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

void add(const TriangleTest& test, SearchCounts* counts) {
    if (!counts) return;
    counts->boxes += test.counts.boxes;
    counts->triangles += test.counts.triangles;
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

World::World(const scene::Scene& scene, int threads)
    : triangles_(scene), single_sided_(single_sided(scene)), size_(size_of(scene)) {
    const std::vector<HierarchyTriangle> all = hierarchy_triangles(triangles_);
    all_ = Hierarchy(all, threads);
    if (!std::all_of(scene.objects.begin(), scene.objects.end(),
                     [&](const scene::Object& o) { return casts(scene, o); }))
        casting_ = Hierarchy(casting_triangles(scene, triangles_, all), threads);
}

std::optional<scene::TrianglePoint> World::nearest(const Ray& ray, double high, std::uint32_t from,
                                                   SearchCounts* counts) const {
    NearestTest test(triangles_, single_sided_, ray, high, size_, from);
    Met met;
    for (;;) {
        all_.find(rounded(ray, high, size_, from), test);
        if (!test.found() || (met = test.result()).triangle != no_triangle) break;
        test.pass();
    }
    add(test, counts);
    if (met.triangle == no_triangle) return std::nullopt;
    return scene::TrianglePoint{met.triangle, point_at(ray, met.t), met.normal};
}

bool World::occluded(const Ray& ray, double high, std::uint32_t from, SearchCounts* counts) const {
    static const std::vector<bool> none;
    NearestTest test(triangles_, none, ray, high, size_, from);
    const Hierarchy& hierarchy = casting_ ? *casting_ : all_;
    hierarchy.find(rounded(ray, high, size_, from), test);
    add(test, counts);
    return test.found();
}

}  // namespace gw::raytrace
