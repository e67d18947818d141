// Polygons to triangles, concave ones too: ear clipping with exact decisions. docs/manual.md,
// "Primitives".
// Does not know holes (a keyhole polygon, whose bridge is walked twice, does as well) and moves no
// vertex.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw {

/// A triangle of a polygon: ordinals of its corners among the polygon's, in the polygon's
/// orientation.
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

/// Exactly n - 2 triangles for n >= 3 corners, whatever they are. Their signed areas add up to the
/// polygon's.
/// - A convex polygon becomes the fan from corner 0 (unless a triangle of it would be flat).
/// - A polygon that does not cross itself, touching itself or not, is covered without overlap, and flat
/// triangles
///   appear only where corners leave no other way (spikes, repeated corners).
/// - A polygon that crosses itself, or has no area, gives some triangles, the same ones each time.
std::vector<PolygonTriangle> triangulate(std::span<const vec2> corners);

/// The same for a polygon in space.
std::vector<PolygonTriangle> triangulate(std::span<const vec3> corners);

}  // namespace gw
