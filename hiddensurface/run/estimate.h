// What a run would take, before it begins: time and memory of an algorithm whose work grows faster
// than the scene. Found by counting the questions that it asks about every k-th polygon, so the
// same input gives the same estimate on every machine; seconds are those of one usual core. Does
// not draw, and does not know the cost of the picture's pixels.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

struct Estimate {
    std::string algorithm;
    std::size_t polygons = 0;       ///< of the scene: those outside the window may cost as much
    double seconds = 0, bytes = 0;  ///< 0: grows with the scene, or the scene is small
};
Estimate estimate(const Algorithm& algorithm, const Input& input);
Estimate estimate(const LineAlgorithm& algorithm, const Input& input);

/// More memory than this is too much, whatever the time.
inline constexpr double most_estimated_bytes = 4e9;

/// Whether the run would take longer than so many seconds, or too much memory; 0: never.
bool is_beyond(const Estimate& estimate, double seconds);

/// "newell: 20,480 polygons would take about 40 minutes and 20 MB"
std::string text_of(const Estimate& estimate);

}  // namespace gw::hiddensurface
