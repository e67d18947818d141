// The measurements of bench_growth: one quantity grows, everything else stays. A file for each
// family of sweeps; main.cpp times them and writes tables and plots.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace gw::growth {

/// One step of a sweep. Runs in a separate process, so that its peak memory can be measured.
struct Step {
    double amount = 0;  ///< of the growing quantity
    /// Prepares, then returns the least time of so many runs, in milliseconds.
    std::function<double(int repeats)> milliseconds;
};

struct Sweep {
    std::string name;      ///< for --only, and of its files
    std::string quantity;  ///< the growing quantity: the plot's axis
    std::vector<Step> steps;
};

/// The least time of several runs after a warm-up, in milliseconds: wall or processor time,
/// whichever is less, so that other processes' turns do not count. `set_up` comes before each run
/// and is not timed.
double least_time(int repeats, const std::function<void()>& run,
                  const std::function<void()>& set_up = nullptr);

/// Frames like workload d of bench/peers, of the scene's geometry: triangles 1x .. 64x, pixels
/// 320x240 .. 4096x4096, passes 1 .. 128, samples 1 .. 256, lights 1 .. 128, threads 1 and 2.
std::vector<Sweep> machine_sweeps(const std::string& scene);

/// Quads of 8x8 pixels in 640x480, 100 .. 100,000 draws with their own matrices, states, textures;
/// passes, lights and lists of them.
std::vector<Sweep> draw_sweeps();

/// Scenes of 1 .. 1,000,000 boxes of 12 triangles: reading, drawing, tracing, solving; materials
/// and lights.
std::vector<Sweep> scene_sweeps();

/// Files with 1,000 .. 1,000,000 of one thing: boxes, lights, materials, numbers of an array in
/// TOML; groups, smoothing groups, faces and vertices at one point in OBJ.
std::vector<Sweep> reader_sweeps();

/// 64x the triangles (5 millions) in 4096x4096 pixels with 64 passes: must stay below 4 GiB.
Step largest_frame(const std::string& scene);

}  // namespace gw::growth
