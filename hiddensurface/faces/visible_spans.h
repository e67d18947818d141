// The core of the scan-line algorithm [L6]. Every scan line has the segments of the plane polygons,
// their ends sorted in x, the sample spans between the ends, and the nearest segment of each. Stores one
// line at a time. Does not draw.
#pragma once

#include "hiddensurface/interface/algorithm.h"

namespace gw::hiddensurface {

/// Part of a scan line on which one triangle is nearest.
struct VisibleSpan {
    Run run;
    std::size_t polygon = 0;   ///< index
    std::size_t triangle = 0;  ///< of the polygon
};

using SpanSink = std::function<void(const std::vector<VisibleSpan>& line)>;

/// Calls `sink` once for each line that is not empty, from the top down; spans are left to right.
/// Agrees bit for bit with a Z-buffer with z < Z: of equal depths the first polygon's is seen. Counts
/// sorts, crossings, depths, spans and peak bytes.
void for_visible_spans(const Input& input, Counts& counts, StepLog& log, const SpanSink& sink);

}  // namespace gw::hiddensurface
