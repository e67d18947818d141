// Whether two pieces overlap in the window. Does not look at depth.
#pragma once

#include "hiddensurface/model/piece.h"

namespace gw::hiddensurface {

/// Least and greatest coordinate of a piece along x, y or z.
std::pair<double, double> extent(const Piece& piece, int axis);

/// Neighbours made by a cut may reach over it by the rounding of its ends: less than this, in grid
/// units.
constexpr double border = 0x1p-20;

/// The intervals share more than a border.
inline bool overlap(const std::pair<double, double>& a, const std::pair<double, double>& b) {
    return a.first + border < b.second && b.first + border < a.second;
}

/// Some part of one and some part of the other share more than a border: no side of either
/// separates them.
bool projections_overlap(const Piece& a, const Piece& b);

}  // namespace gw::hiddensurface
