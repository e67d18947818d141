// The frames whose time is taken as one quantity grows, the rest as in workload d of bench/peers.
// Does not time.
#pragma once

#include "bench/peers/frame.h"
#include "bench/peers/workload.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::growth {

/// One frame of a sweep: made when its turn comes, since the largest fill memory.
struct Step {
    double amount = 0;  ///< of what grows
    int threads = 1;
    std::function<peers::Frame()> frame;
    peers::Workload workload;
};

struct Sweep {
    std::string name;  ///< of what grows
    std::vector<Step> steps;
};

/// Triangles 1x .. 64x, pixels 320x240 .. 4096x4096, passes 1 .. 128, samples 1 .. 256, lights 1 ..
/// 128, threads 1 and 2.
std::vector<Sweep> sweeps(const std::string& scene);

/// 64x the triangles (5 millions) in 4096x4096 pixels with 64 passes: what must stay below 4 GiB.
Step largest(const std::string& scene);

}  // namespace gw::growth
