// The painter's algorithm [L5]: polygons sorted by one distance each and drawn far to near. Fails
// where the distance of one point does not say which polygon hides which; never splits.
#pragma once

#include "hiddensurface/run/algorithm.h"

namespace gw::hiddensurface {

/// `key`: Polygon::farthest, nearest or centroid. Equal distances keep the scene's order.
Output paint(const Input& input, StepLog& log, const std::string& pass, double Polygon::*key);

}  // namespace gw::hiddensurface
