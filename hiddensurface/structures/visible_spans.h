// The scan-line algorithm's heart [L6]: for every scan line the segments of the polygons, their
// ends sorted in x, the sample spans between the ends, and the nearest segment of each. Holds one
// line at a time. Does not draw.
#pragma once

#include "hiddensurface/run/algorithm.h"

namespace gw::hiddensurface {

/// Part of a scan line on which one triangle is nearest.
struct VisibleSpan {
    Run run;
    std::size_t polygon = 0;   ///< index
    std::size_t triangle = 0;  ///< of the polygon
};

using SpanSink = std::function<void(const std::vector<VisibleSpan>& line)>;

/// Lines from the top down, each once, left to right, also empty ones left out. Agrees with a
/// Z-buffer that keeps z < Z bit for bit: equal depths go to the polygon that comes first. Counts
/// sorts, crossings, depths, spans and peak bytes.
void for_visible_spans(const Input& input, Counts& counts, StepLog& log, const SpanSink& sink);

}  // namespace gw::hiddensurface
