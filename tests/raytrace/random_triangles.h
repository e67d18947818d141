// Seeded triangles and rays, the same on every machine.
#pragma once

#include "raytrace/hierarchy/hierarchy.h"

#include <random>

namespace gw::raytrace {

class RandomRays {
public:
    explicit RandomRays(std::uint32_t seed) : bits_(seed) {}

    float number(float low, float high) {
        return low + (high - low) * float(bits_() >> 8) * 0x1p-24f;
    }
    vec3 point(float size) {
        return {number(-size, size), number(-size, size), number(-size, size)};
    }

    std::vector<HierarchyTriangle> triangles(std::size_t count, float size) {
        std::vector<HierarchyTriangle> list;
        for (std::size_t i = 0; i < count; ++i) {
            const vec3 p = point(1);
            list.push_back({{p, p + point(size), p + point(size)}, std::uint32_t(i / 2)});
        }
        return list;
    }

    /// Some along axes, some from corners to corners.
    HierarchyRay ray(const std::vector<HierarchyTriangle>& triangles) {
        HierarchyRay ray{point(2), 0, point(1), 1e30f};
        const auto corner = [&] {
            return triangles[bits_() % triangles.size()].corner[bits_() % 3];
        };
        switch (bits_() % 4) {
            case 0: ray.direction[int(bits_() % 3)] = 0; break;
            case 1:
                ray.direction = vec3(0),
                ray.direction[int(bits_() % 3)] = number(-1, 1) < 0 ? -1.f : 1.f;
                break;
            case 2: ray.direction = corner() - ray.origin; break;
            case 3: ray.origin = corner(); break;
        }
        return ray;
    }

private:
    std::mt19937 bits_;
};

}  // namespace gw::raytrace
