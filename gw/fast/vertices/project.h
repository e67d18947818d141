// Takes many vertices to the window at once: transform, classify, divide, snap, in vectors of
// doubles.
// docs/manual.md, "Vertices", "Window coordinates"; scalar twins: gw/stages/vertex.cpp,
// gw/stages/window.h. Does not clip.
#pragma once

#include "gw/fast/vertices/geometry.h"
#include "gw/stages/clip.h"
#include "gw/stages/window.h"

#include <array>
#include <cstdint>
#include <span>

namespace gw::fast {

/// The transform from object space to the window.
struct Projection {
    dmat4 clip_from_object{1}, eye_from_object{1};
    ViewportTransform viewport;
    DepthRangeState depth_range;
    std::array<ClipPlane, max_clip_planes> clip_planes{};
    const Profile& profile;
};

/// The position part of run_vertex().
inline void place_position(const Projection& projection, const dvec4& p_object, ClipPosition& v) {
    v.clip = transform(projection.clip_from_object, p_object);
    for (std::size_t k = 0; k < max_clip_planes; ++k)
        if (projection.clip_planes[k].enable)
            v.distance[k] = dot4(projection.clip_planes[k].plane,
                                 transform(projection.eye_from_object, p_object));
}

/// A bit for each clip plane that a vertex is outside of. The high bits reject the vertex whatever
/// the planes say; a vertex that is not finite has only such a bit.
using Outcode = std::uint32_t;
inline constexpr Outcode not_finite = 1u << 30, not_in_front = 1u << 31;

/// Vertices of a mesh. If the outcode is not 0, `at` has no meaning and w is 1.
struct ProjectedVertices {
    std::span<const vec3> positions;
    std::span<const float> fourth;  ///< their w; empty: 1
    Outcode* outcode;
    SnappedVertex* at;
    double* w;
};
void project(const Projection& projection, const ProjectedVertices& vertices);

/// Vertices that no plane cuts.
void to_window(const Projection& projection, std::span<const ClipPosition> vertices,
               SnappedVertex* at);

}  // namespace gw::fast
