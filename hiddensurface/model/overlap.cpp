// Separating lines: two convex polygons are apart exactly where a side of one of them separates
// them.
#include "hiddensurface/model/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gw::hiddensurface {
namespace {

std::pair<double, double> along(const Loop& loop, const dvec2& direction) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const dvec3& p : loop) {
        const double d = direction.x * p.x + direction.y * p.y;
        low = std::min(low, d);
        high = std::max(high, d);
    }
    return {low, high};
}

bool side_separates(const Loop& a, const Loop& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const dvec3 side = a[(i + 1) % a.size()] - a[i];
        if (side.x == 0 && side.y == 0) continue;
        const dvec2 across = dvec2(side.y, -side.x) / std::sqrt(side.x * side.x + side.y * side.y);
        if (!overlap(along(a, across), along(b, across))) return true;
    }
    return false;
}

}  // namespace

std::pair<double, double> extent(const Piece& piece, int axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Loop& part : piece.parts)
        for (const dvec3& p : part) {
            low = std::min(low, p[axis]);
            high = std::max(high, p[axis]);
        }
    return {low, high};
}

bool projections_overlap(const Piece& a, const Piece& b) {
    for (const Loop& p : a.parts)
        for (const Loop& q : b.parts)
            if (!side_separates(p, q) && !side_separates(q, p)) return true;
    return false;
}

}  // namespace gw::hiddensurface
