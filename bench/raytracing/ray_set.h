// The rays of the ordinary ray tracer's picture, written down, so that others can be asked the
// same.
#pragma once

#include "raytrace/tracer/tracer.h"

#include <vector>

namespace gw::bench {

/// As World takes it.
struct PictureRay {
    raytrace::Ray ray;
    double high = 0;
    std::uint32_t from = raytrace::no_triangle;
};

struct RaySet {
    std::vector<PictureRay> primary, reflected, shadow;
};

/// To the second ray.
RaySet rays_of_picture(const scene::Scene& scene, const raytrace::World& world,
                       const scene::View& view);

/// Processor seconds of one thread, the best of several runs: the renderers' own search, whose test
/// is in double; the search in float32 alone; Embree's (robust, one ray at a time). And the number
/// of rays that only the renderers or only Embree find to hit.
struct Race {
    double ours = 1e30, float32 = 1e30, embree = 1e30;
    std::size_t rays = 0, differ = 0;
};
struct RayRaces {
    Race primary, reflected, shadow;
    Race build;  ///< of the hierarchies
};
RayRaces race(const RaySet& rays, const raytrace::World& world, int runs);

/// Processor seconds of this process so far: other processes do not count.
double processor_seconds();

}  // namespace gw::bench
