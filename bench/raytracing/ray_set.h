// The rays of the ordinary ray tracer's picture, written down, so that others can be asked the same.
#pragma once

#include "raytrace/tracer.h"

#include <vector>

namespace gw::bench {

struct RaySet {
    std::vector<raytrace::HierarchyRay> nearest;  ///< primary and reflected
    std::vector<raytrace::HierarchyRay> shadow;
    std::size_t size() const { return nearest.size() + shadow.size(); }
};

/// To the second ray.
RaySet rays_of_picture(const scene::Scene& scene, const raytrace::World& world, const scene::View& view);

/// Seconds of one thread for the set, ours and Embree's (robust, one ray at a time), and how many hits differ
/// in whether there is one.
struct TraceTimes {
    double ours = 0, embree = 0;
    std::size_t differ = 0;
};
TraceTimes trace_times(const RaySet& rays, const raytrace::World& world);

/// Processor seconds of this process so far: what others run on the machine does not count.
double processor_seconds();

}  // namespace gw::bench
