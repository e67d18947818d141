// Random paths through closed bodies: a ray that enters a body must leave it before it enters again.
#pragma once

#include "gw/stages/vertex.h"
#include "raytrace/tracer/surface.h"
#include "raytrace/tracer/world.h"
#include "scene/scene_builder.h"

#include <glm/common.hpp>

#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace gw::raytrace {

/// Closed bodies, each an object of its own.
class Bodies {
public:
    scene::Scene scene;

    void add(MeshData mesh, const dmat4& world_from_object = dmat4(1)) {
        scene.objects.push_back({.name = "body " + std::to_string(scene.objects.size()),
                                 .mesh = scene::make_numbered_mesh(std::move(mesh), next_),
                                 .world_from_object = world_from_object});
        if (scene.materials.empty()) scene.materials.emplace_back();
    }

private:
    std::uint32_t next_ = 0;
};

/// Random numbers, directions, and points of a scene's triangles.
class SceneRays {
public:
    explicit SceneRays(std::uint32_t seed) : bits_(seed) {}

    std::uint32_t bits() { return std::uint32_t(bits_()); }
    double number() { return double(bits_() >> 8) * 0x1p-24; }
    dvec3 direction() {
        for (;;) {
            const dvec3 d(2 * number() - 1, 2 * number() - 1, 2 * number() - 1);
            const double square = dot3(d, d);
            if (square > 1e-4 && square < 1) return normalized(d);
        }
    }
    std::uint32_t triangle(const World& world) { return bits() % world.triangles().size(); }
    /// A random point of a triangle; or of one of its sides, or a corner, but for 0 or 10^-3 to 10^-9.
    dvec3 target(const World& world, std::uint32_t triangle) {
        const auto corner = world.triangles().corners(triangle);
        const auto kind = bits() % 4;
        const double b = kind == 0 ? 0 : number(), c = kind < 2 ? 0 : number() * (1 - b);
        const dvec3 p = corner[0] + b * (corner[1] - corner[0]) + c * (corner[2] - corner[0]);
        if (kind >= 2) return p;
        double beside = 1e-3;
        for (auto k = bits() % 7; k > 0; --k) beside /= 10;
        return bits() % 8 == 0 ? p : p + beside * direction();
    }
    /// From far outside of the scene towards such a point; now and then from integers through a
    /// corner, not rounded if the corner is at integers.
    Ray aimed(const World& world) {
        Ray ray{direction() * 50.0, {}};
        if (bits() % 8 == 0) {
            ray.origin = glm::round(ray.origin);
            ray.direction = world.triangles().corners(triangle(world))[0] - ray.origin;
            return ray;
        }
        ray.direction = normalized(target(world, triangle(world)) - ray.origin);
        return ray;
    }
    /// The surface at such a point, seen straight from in front or from behind.
    Surface seen(const World& world, bool from_front) {
        const std::uint32_t number = triangle(world);
        const auto corner = world.triangles().corners(number);
        const dvec3 normal = cross3(corner[1] - corner[0], corner[2] - corner[0]);
        const dvec3 direction = normalized(normal) * (from_front ? -1.0 : 1.0);
        return surface(world.triangles(), {number, target(world, number), normal}, direction,
                       {.width = 1, .height = 1});
    }
    /// On the seen side of the triangle, or through it; now and then grazing.
    dvec3 leaving(const Surface& s, bool through) {
        dvec3 d = direction();
        while (dot3(d, s.plane_normal) == 0) d = direction();  // neither
        double height = dot3(d, s.plane_normal);
        if (bits() % 4 == 0) {
            d -= height * 0.999 * s.plane_normal;
            height *= 0.001;
        }
        if ((height < 0) != through) d -= 2 * height * s.plane_normal;
        return normalized(d);
    }

private:
    std::mt19937 bits_;
};

struct PathCounts {
    std::uint64_t paths = 0, hits = 0;
    std::uint64_t violations = 0;  ///< entered twice, or left without entering
    std::uint64_t caught = 0;      ///< paths that left the scene inside a body
};

/// Follows paths from outside the scene, aimed at random points of triangles, at their corners and
/// sides and closely beside them. At every hit the path goes straight on, or to a random direction
/// on the same side of the triangle or on the other.
class PathCounter {
public:
    PathCounter(const scene::Scene& scene, std::uint32_t seed)
        : world_(scene, 1),
          view_{.width = 1, .height = 1},
          inside_(scene.objects.size()),
          random_(seed) {}

    PathCounts count(std::uint64_t paths) {
        PathCounts counts;
        for (; counts.paths < paths; ++counts.paths) follow(counts);
        return counts;
    }

private:
    static constexpr int most_hits = 12;

    void follow(PathCounts& counts) {
        inside_.assign(inside_.size(), false);
        Ray ray = random_.aimed(world_);
        std::uint32_t from = no_triangle;
        for (int hit = 0; hit < most_hits; ++hit) {
            const auto at = world_.nearest(ray, std::numeric_limits<double>::infinity(), from);
            if (!at) {
                for (const bool is_inside : inside_) counts.caught += is_inside;
                return;
            }
            ++counts.hits;
            const Surface s = surface(world_.triangles(), *at, ray.direction, view_);
            const std::size_t body = world_.triangles().object_of(at->triangle);
            if (inside_[body] == s.front) {
                ++counts.violations;
                return;
            }
            const auto way = random_.bits() % 8;
            const bool through = way >= 2;
            if (through) inside_[body] = s.front;
            ray = {s.start, way >= 6 ? ray.direction : random_.leaving(s, through)};
            from = at->triangle;
        }
    }
    World world_;
    scene::View view_;
    std::vector<bool> inside_;  ///< by object
    SceneRays random_;
};

}  // namespace gw::raytrace
