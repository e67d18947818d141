// The measured scenes, each given by one number, and the results of a measurement.
#pragma once

#include "bench/raytracing/contest.h"
#include "bench/raytracing/ray_set.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::bench {

struct Sweep {
    std::string name, x_label;
    int log;  ///< of the x axis; 0: linear
    std::vector<double> values;
    std::function<scene::Scene(double)> scene;
    bool samples = false;  ///< x is the number of samples
};

/// Fig. 9 [K4f]; lights, glossy share of the pixels with one and four lights, polygons, samples.
std::vector<Sweep> sweeps();

/// Fig. 9, and the same room with twelve balls of this number of triangles together.
scene::Scene fig9();
scene::Scene room_of_balls(double triangles);

struct Row {
    double x;
    Contest c;
    RayRaces rays;
    std::size_t megabytes = 0;  ///< the process's peak memory so far
};

}  // namespace gw::bench
