// Divides a surface into charts, each seen whole from one direction: planar parts, and curved ones
// whose normals differ little. Does not flatten them.
#pragma once

#include "gw/base/types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace gw::radiosity {

/// World space. Corners that are the same point have the same index.
struct Surface {
    std::vector<dvec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    /// Twice the area, along the normal.
    dvec3 cross(std::uint32_t t) const {
        const auto& [a, b, c] = triangles[t];
        return cross3(points[b] - points[a], points[c] - points[a]);
    }

    /// Whether it has an area. One thinner than a millionth of its length is a rounding error.
    bool solid(std::uint32_t t) const {
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 side = points[triangles[t][(k + 1) % 3]] - points[triangles[t][k]];
            longest = std::max(longest, dot3(side, side));
        }
        const dvec3 n = cross(t);
        return dot3(n, n) > 1e-12 * longest * longest;
    }
};

struct Chart {
    std::vector<std::uint32_t> triangles;  ///< with an area, ascending
    dvec3 normal{0};                       ///< unit; every triangle's is within 75 degrees of it
    bool planar = false;
    dvec3 along{0};  ///< unit, in the plane: the longest side on the border, or any direction
};

/// Triangles that share an edge are in one chart if the surface bends there by at most 25 degrees
/// and they are within 40 degrees of the chart's first. Triangles without area are in none.
std::vector<Chart> charts(const Surface& surface);

/// A chart of some triangles of a chart.
Chart chart_of(const Surface& surface, std::vector<std::uint32_t> triangles);

}  // namespace gw::radiosity
