// Clipping in clip coordinates, in double. docs/manual/geometry.md, "Clipping".
// The sides of the window are not clip planes; the sides of a guard band far outside are. Does not
// project or cull.
#pragma once

#include "gw/stages/vertex.h"

#include <cstdint>
#include <vector>

namespace gw {

struct ViewportTransform;

/// The guard band in window pixels: snapped coordinates fit [guard_low, guard_high).
inline constexpr int guard_low = -6144, guard_high = 10240;

/// The clip planes in their order: near, far, user 0 .. 5, guard left, right, bottom, top.
inline constexpr int clip_plane_count = 2 + max_clip_planes + 4;
inline constexpr std::uint32_t all_clip_planes = (1u << clip_plane_count) - 1;  ///< a bit each
/// Signed distance of v to plane `i`; >= 0 is inside. A user plane that is off clips nothing.
double clip_distance(const ClipPosition& v, int i, const ViewportTransform& viewport);

/// The result of clipping.
struct Clipped {
    /// a convex polygon, the two ends of a line, a point; empty: rejected
    std::vector<Vertex> vertices;
    bool cut = false;  ///< whether a plane cut something off
};

/// Clips a polygon (3 or more vertices), a line (2) or a point (1). Rejects the whole primitive if
/// the clip coordinates of a given or new vertex are not finite.
Clipped clip(std::vector<Vertex> vertices, const ViewportTransform& viewport);

/// The same for positions alone, in place. Keeps its memory from call to call.
struct PositionClipper {
    std::vector<ClipPosition> vertices{}, left{};
    std::vector<double> distances{};

    /// Returns Clipped::cut. `planes` has a bit for each plane that a given or new vertex may lie
    /// outside of.
    bool clip(const ViewportTransform& viewport, std::uint32_t planes);
};

/// I + t (O - I) with t = dI / (dI - dO), I inside and O outside. Always from inside to outside, so
/// both neighbours of an edge get the same bits.
Vertex interpolate(const Vertex& inside, const Vertex& outside, double t);

}  // namespace gw
