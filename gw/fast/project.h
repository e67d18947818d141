// Many vertices to the window at once: transform, classify, divide, snap, in vectors of doubles.
// docs/manual.md, "Vertices", "Window coordinates"; scalar twins: gw/vertex.cpp, gw/window.h. Does not clip.
#pragma once

#include "gw/clip.h"
#include "gw/window.h"

#include <array>
#include <cstdint>
#include <span>

namespace gw::fast {

/// What takes positions to the window.
struct Projection {
    dmat4 clip_from_object{1}, eye_from_object{1};
    ViewportTransform viewport;
    DepthRangeState depth_range;
    std::array<ClipPlane, max_clip_planes> clip_planes{};
    Profile profile;
};

/// Bit per clip plane that a vertex is outside of; the high bits reject it whatever the planes say. A vertex
/// that is not finite has that bit alone.
using Outcode = std::uint32_t;
inline constexpr Outcode not_finite = 1u << 30, not_in_front = 1u << 31;

inline constexpr std::size_t project_batch = 8;

/// Up to project_batch vertices; x, y, z, w are right for those with outcode 0 only. Not made: there are no
/// vectors of doubles.
struct Projected {
    bool made = false;
    std::array<Outcode, project_batch> outcode{};
    std::array<std::int32_t, project_batch> x{}, y{};
    std::array<std::uint32_t, project_batch> z{};
    std::array<double, project_batch> w{};
};
Projected project(const Projection& projection, std::span<const vec3> positions);

}  // namespace gw::fast
