// Whether two pieces overlap in the window. Does not look at depth.
#pragma once

#include "hiddensurface/piece.h"

namespace gw::hiddensurface {

/// Least and greatest coordinate of a piece along x, y or z.
std::pair<double, double> extent(const Piece& piece, int axis);

/// The intervals share more than an end.
inline bool overlap(const std::pair<double, double>& a, const std::pair<double, double>& b) {
    return a.first < b.second && b.first < a.second;
}

/// Some part of one and some part of the other share more than a border: no side of either separates them.
bool projections_overlap(const Piece& a, const Piece& b);

}  // namespace gw::hiddensurface
