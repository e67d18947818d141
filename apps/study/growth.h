// The growth of every hidden-surface and hidden-line algorithm's counters and time: with the number
// of polygons, with depth complexity, with resolution, and with the change from frame to frame. One
// parameter varies, the others stay. Hidden surfaces: triangles in all directions, some through each
// other. Hidden lines: hills over a grid, which all those algorithms accept. Does not plot.
#pragma once

#include "apps/study/difference.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gw::study {

/// The counters of one algorithm at one place of an axis. "seconds" is the processor time of algorithm
/// and machine, the least of up to three runs.
struct GrowthPoint {
    std::string axis;  ///< growth_axes()
    bool lines = false;
    double x = 0;
    std::string algorithm;
    std::map<std::string, double> values;
};

/// An algorithm that was stopped after `x`: the next run would have taken longer than the limit.
struct GrowthCut {
    std::string axis, algorithm;
    double x = 0, seconds = 0;  ///< of the last run
};

struct Growth {
    std::vector<GrowthPoint> points;
    std::vector<GrowthCut> cuts;
};

struct GrowthAxis {
    std::string name, label;
    int log = 2;  ///< base of the plots' axis
};
/// polygons, depth, resolution, frames.
const std::vector<GrowthAxis>& growth_axes();
/// The names of all values: "seconds", "moved", "changed", then the counters in their order. Only
/// `frames` has "moved", the polygons that must be moved to turn the order of the frame before into
/// this one's, and "changed", the pixels that show another polygon.
std::vector<std::string> growth_values(bool lines);
/// The names of the algorithms that claim to be right, in the table's order.
std::vector<std::string> right_algorithms();

struct GrowthOptions {
    double limit = 0.5;             ///< seconds; a longer run, or a longer next one, ends an axis
    int threads = 1;                ///< of the machine; times are sums over all threads
    std::string axis;               ///< of growth_axes(); empty: all
    std::vector<std::string> only;  ///< algorithms; empty: all
};

/// Runs every algorithm on every axis, from the smallest size up to the limit.
Growth growth(const GrowthOptions& options, const std::function<void(const std::string&)>& say);

/// The number of elements of `before` that must be moved to give the order of `after`. The longest
/// common sequence stays.
std::size_t moves_between(const std::vector<std::uint32_t>& before,
                          const std::vector<std::uint32_t>& after);

}  // namespace gw::study
