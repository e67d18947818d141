// The parts of a facet in the texels that it covers. Does not add up what covers a texel (figures.h
// does).
#pragma once

#include "radiosity/model/geometry.h"
#include "radiosity/model/pixmap_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gw::radiosity {

/// What may cover a texel, in texels: once, and rounding.
inline constexpr double most_share = 1 + 1e-3;

/// The first and last texel that [low, high] touches.
inline std::pair<int, int> touched(double low, double high, int count) {
    const int first = std::clamp(static_cast<int>(std::floor(low)), 0, count - 1);
    return {first, std::clamp(static_cast<int>(std::ceil(high)) - 1, first, count - 1)};
}

inline std::pair<double, double> range(const Polygon2& polygon, int axis) {
    double low = polygon[0][axis], high = low;
    for (int i = 1; i < polygon.n; ++i) {
        low = std::min(low, polygon[i][axis]);
        high = std::max(high, polygon[i][axis]);
    }
    return {low, high};
}

/// visit(x, y, part) for each texel that the triangle covers a part of.
template <class Visit>
void for_each_part(const Triangle2& triangle, const Pixmap& pixmap, Visit visit) {
    Polygon2 whole;
    for (const dvec2& uv : triangle) whole.add(uv);
    const auto [low_v, high_v] = range(whole, 1);
    const auto [y0, y1] = touched(low_v, high_v, pixmap.height);
    for (int y = y0; y <= y1; ++y) {
        const Polygon2 row = cut(cut(whole, 1, y, 1), 1, y + 1, -1);
        if (row.n < 3) continue;
        const auto [low_u, high_u] = range(row, 0);
        const auto [x0, x1] = touched(low_u, high_u, pixmap.width);
        for (int x = x0; x <= x1; ++x) {
            const Polygon2 piece = cut(cut(row, 0, x, 1), 0, x + 1, -1);
            if (piece.n >= 3) visit(x, y, piece);
        }
    }
}

/// Whether a pixmap has a curved figure: one of many facets.
inline bool is_curved(const Pixmap& pixmap) {
    constexpr std::size_t most_plane = 2;  // a quad that is not quite plane has two facets
    return pixmap.facets.size() > most_plane;
}

}  // namespace gw::radiosity
