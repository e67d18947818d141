#include "bench/raytracing/ray_set.h"

#include "gw/stages/texgen.h"
#include "gw/stages/vertex.h"
#include "scene/draw/view.h"
#include "tests/raytrace/embree_scene.h"

#include <algorithm>
#include <ctime>
#include <optional>

namespace gw::bench {
namespace {

using raytrace::HierarchyRay;

constexpr float far = 3e38f;
constexpr float skin = 1e-5f;

class Recorder {
public:
    Recorder(const scene::Scene& scene, const raytrace::World& world, const scene::View& view)
        : scene_(scene), world_(world), view_(view) {}

    void follow(const raytrace::Ray& ray, double high, std::uint32_t from, int rays_left) {
        const bool first = from == raytrace::no_triangle;
        (first ? set.primary : set.reflected).push_back({ray, high, from});
        const auto at = world_.nearest(ray, high, from);
        if (!at) return;
        const auto s = raytrace::surface(world_.triangles(), *at, normalized(ray.direction), view_);
        for (const scene::Light& light : scene_.lights) {
            const dvec3 way = dvec3(light.position) - at->p;
            const bool faces = dot3(way, s.normal) > 0 && dot3(way, s.plane_normal) > 0;
            if (light.shadow != scene::Shadow::None && faces)
                set.shadow.push_back({{s.start, way}, 1, at->triangle});
        }
        const scene::Object& object = scene_.objects[world_.triangles().object_of(at->triangle)];
        if (rays_left > 0 && raytrace::is_traced(scene_.materials[object.material]))
            follow({s.start, reflected(s.direction, s.normal)}, far, at->triangle, rays_left - 1);
    }

    RaySet set;

private:
    const scene::Scene& scene_;
    const raytrace::World& world_;
    const scene::View& view_;
};

/// As the hierarchy and Embree take it: a second ray begins a little behind its start.
HierarchyRay in_float32(const PictureRay& r) {
    return {vec3(r.ray.origin), r.from == raytrace::no_triangle ? 0 : skin, vec3(r.ray.direction),
            float(r.high), r.from};
}

/// Asks all three everything, ray by ray.
template <class Ours, class Float32, class Theirs>
Race race(const std::vector<PictureRay>& rays, int runs, const Ours& ours, const Float32& float32,
          const Theirs& theirs) {
    Race out{.rays = rays.size()};
    std::vector<HierarchyRay> rounded;
    for (const PictureRay& ray : rays) rounded.push_back(in_float32(ray));
    std::vector<char> hits(rays.size()), single_hits(rays.size()), their_hits(rays.size());
    const auto ask = [](const auto& asked, const auto& hit, std::vector<char>& found,
                        double& best) {
        const double start = processor_seconds();
        for (std::size_t i = 0; i < asked.size(); ++i) found[i] = hit(asked[i]);
        best = std::min(best, processor_seconds() - start);
    };
    for (int run = 0; run < runs; ++run) {
        ask(rays, ours, hits, out.ours);
        ask(rounded, float32, single_hits, out.float32);
        ask(rounded, theirs, their_hits, out.embree);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) out.differ += hits[i] != their_hits[i];
    return out;
}

}  // namespace

double processor_seconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

RaySet rays_of_picture(const scene::Scene& scene, const raytrace::World& world,
                       const scene::View& view) {
    Recorder recorder(scene, world, view);
    const scene::PixelRays rays(view);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const scene::PixelRay ray = rays.through(x + 0.5, y + 0.5);
            recorder.follow({ray.o, ray.d}, 1, raytrace::no_triangle, 1);
        }
    return std::move(recorder.set);
}

RayRaces race(const RaySet& rays, const raytrace::World& world, int runs) {
    const auto triangles = raytrace::hierarchy_triangles(world.triangles());
    RayRaces out;
    out.build.rays = triangles.size();
    std::optional<raytrace::EmbreeScene> embree;
    for (int run = 0; run < runs; ++run) {
        double start = processor_seconds();
        const raytrace::Hierarchy ours(triangles, 1);
        out.build.ours = std::min(out.build.ours, processor_seconds() - start);
        start = processor_seconds();
        embree.emplace(triangles);
        out.build.embree = std::min(out.build.embree, processor_seconds() - start);
    }
    out.build.float32 = out.build.ours;
    const auto nearest = [&](const PictureRay& r) {
        return world.nearest(r.ray, r.high, r.from).has_value();
    };
    const auto any = [&](const PictureRay& r) { return world.occluded(r.ray, r.high, r.from); };
    const auto single_nearest = [&](const HierarchyRay& r) {
        return world.hierarchy().nearest(r).has_value();
    };
    const auto single_any = [&](const HierarchyRay& r) { return world.hierarchy().occluded(r); };
    const auto their_nearest = [&](const HierarchyRay& r) {
        return embree->nearest(r).triangle != raytrace::no_triangle;
    };
    const auto their_any = [&](const HierarchyRay& r) { return embree->occluded(r); };
    out.primary = race(rays.primary, runs, nearest, single_nearest, their_nearest);
    out.reflected = race(rays.reflected, runs, nearest, single_nearest, their_nearest);
    out.shadow = race(rays.shadow, runs, any, single_any, their_any);
    return out;
}

}  // namespace gw::bench
