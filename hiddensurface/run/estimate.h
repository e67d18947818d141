// Predicts the time and memory of a run of an algorithm whose work grows faster than the scene. It
// counts the questions that the algorithm asks about a sample of the polygons (Sampling), so the same
// input gives the same estimate on every machine. Seconds are those of a typical core. Does not draw,
// and does not know the cost of the picture's pixels.
#pragma once

#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

struct Estimate {
    std::string algorithm;
    std::size_t polygons = 0;       ///< all of the scene: those outside the window may cost as much
    double seconds = 0, bytes = 0;  ///< 0: grows with the scene, or the scene is small
};
Estimate estimate(const Algorithm& algorithm, const Input& input);
Estimate estimate(const LineAlgorithm& algorithm, const Input& input);

/// More memory than this is too much for any run.
inline constexpr double most_estimated_bytes = 4e9;

/// Whether the run would take longer than `seconds`, or too much memory; 0: never.
bool is_beyond(const Estimate& estimate, double seconds);

/// "newell: 20,480 polygons would take about 40 minutes and 20 MB"
std::string text_of(const Estimate& estimate);

}  // namespace gw::hiddensurface
