// Triangles of a convex or concave polygon: ear clipping with exact decisions.
// docs/manual/geometry.md, "Primitives". Does not move a vertex. Does not know holes; a border that
// runs along a bridge to the hole and back has the same effect.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw {

/// A triangle of a polygon by ordinals of the polygon's corners, in the polygon's orientation.
struct PolygonTriangle {
    std::array<std::uint32_t, 3> corner;
    /// bit k: the side from corner[k] to corner[k+1] is a side of the polygon
    std::uint8_t edges = 0;
    bool operator==(const PolygonTriangle&) const = default;
};

/// The polygon seen along the axis nearest to its Newell normal, so that its area is not negative.
/// Coordinates are those of the corners, unrounded: a projection along an axis, not along the
/// normal.
std::vector<vec2> project_polygon(std::span<const vec3> corners);

/// Exactly n - 2 triangles for any n >= 3 corners. Their signed areas add up to the polygon's.
/// - A convex polygon becomes the fan from corner 0, unless a triangle of the fan would be flat.
/// - A polygon that does not cross itself is covered without overlap, even if it touches itself.
///   Flat triangles appear only if the corners leave no other choice (spikes, repeated corners).
/// - A polygon that crosses itself or has no area gives n - 2 triangles, always the same.
std::vector<PolygonTriangle> triangulate(std::span<const vec2> corners);

/// The same for a polygon in space.
std::vector<PolygonTriangle> triangulate(std::span<const vec3> corners);

/// Whether triangulate() gives the fan from corner 0. Most polygons have few corners and are convex:
/// this takes no memory.
bool becomes_fan(std::span<const vec3> corners);

/// The sides of triangle (0, i, i + 1) of a fan that are sides of its polygon, a bit each.
constexpr std::uint8_t fan_edges(std::size_t i, std::size_t corners) {
    return std::uint8_t((i == 1 ? 1 : 0) | 2 | (i + 2 == corners ? 4 : 0));
}

}  // namespace gw
