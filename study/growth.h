// How the counters and the time of every hidden-surface and hidden-line algorithm grow: with the
// number of polygons, with depth complexity, with resolution, and with what changes from frame to
// frame. One parameter varies, the others stay. Hidden surfaces: triangles in all directions, some
// through each other. Hidden lines: hills over a grid, which all of those algorithms take. Does not
// plot.
#pragma once

#include "study/difference.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gw::study {

/// What one algorithm counted at one place of an axis; "seconds" is the processor time of algorithm
/// and machine, the least of up to three runs. Only counters that the algorithm has.
struct GrowthPoint {
    std::string axis;  ///< growth_axes()
    bool lines = false;
    double x = 0;
    std::string algorithm;
    std::map<std::string, double> values;
};

/// An algorithm that was not asked beyond `x`: it would have taken longer than the limit.
struct GrowthCut {
    std::string axis, algorithm;
    double x = 0, seconds = 0;  ///< the last asked
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
/// The names of all values, in the order of the counters; "seconds" first, then what only `frames`
/// has: "moved", polygons of the frame before that would have to be moved in its order to give this
/// one's, and "changed", pixels that show another polygon.
std::vector<std::string> growth_values(bool lines);
/// Of the algorithms that claim to be right, in the table's order.
std::vector<std::string> right_algorithms();

struct GrowthOptions {
    /// seconds: where a run takes longer, or the next one would, an axis ends
    double limit = 0.5;
    int threads = 1;                ///< of the machine; times are sums over all
    std::string axis;               ///< of growth_axes(); empty: all
    std::vector<std::string> only;  ///< algorithms; empty: all
};

/// Every algorithm on every axis, from the smallest size up until the limit.
Growth growth(const GrowthOptions& options, const std::function<void(const std::string&)>& say);

/// How many of `before` must be moved to give the order of `after`, as long as the longest sequence
/// that both have in common stays.
std::size_t moves_between(const std::vector<std::uint32_t>& before,
                          const std::vector<std::uint32_t>& after);

}  // namespace gw::study
