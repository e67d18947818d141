// Clipping in clip coordinates, in double. docs/manual.md, "Clipping".
// The window's sides are not clip planes: a guard band far outside them is. Does not project or
// cull.
#pragma once

#include "gw/stages/vertex.h"

#include <cstdint>
#include <vector>

namespace gw {

/// The guard band in window pixels: snapped coordinates fit [guard_low, guard_high).
inline constexpr int guard_low = -6144, guard_high = 10240;

/// A viewport with its default resolved: where clip coordinates land in the window.
struct ViewportTransform {
    double half_width = 1, half_height = 1, center_x = 0, center_y = 0;
};

/// Signed distances to all planes in their fixed order: near, far, user 0 .. 5, guard left, right,
/// bottom, top.
inline constexpr int clip_plane_count = 2 + max_clip_planes + 4;
inline constexpr std::uint32_t all_clip_planes = (1u << clip_plane_count) - 1;  ///< a bit each
/// Distance of v to plane `i`; >= 0 is inside. A user plane that is off has every vertex inside.
double clip_distance(const ClipPosition& v, int i, const ViewportTransform& viewport);

/// What clipping leaves, and whether it changed anything.
struct Clipped {
    /// a convex polygon, a line's two ends, a point; empty: rejected
    std::vector<Vertex> vertices;
    bool cut = false;
};

/// Clips a polygon (3 or more vertices), a line (2) or a point (1). A vertex whose clip coordinates
/// are not finite, given or new, rejects it whole.
Clipped clip(std::vector<Vertex> vertices, const ViewportTransform& viewport);

/// The same of positions alone, in place (empty: rejected); whether it changed anything. Keeps its
/// memory.
struct PositionClipper {
    std::vector<ClipPosition> vertices{}, left{};
    std::vector<double> distances{};

    /// `planes`: a bit for each plane that some vertex may be outside of, or a new vertex come to
    /// be.
    bool clip(const ViewportTransform& viewport, std::uint32_t planes);
};

/// I + t (O - I), t = dI / (dI - dO), I inside, O outside: both neighbours of an edge get the same
/// bits.
Vertex interpolate(const Vertex& inside, const Vertex& outside, double t);

}  // namespace gw
