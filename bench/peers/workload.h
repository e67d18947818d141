// The timed frames, as data that each peer plays in its own way. Does not draw.
#pragma once

#include "gw/state.h"

#include <span>
#include <string>
#include <vector>

namespace gw::peers {

enum class Geometry { Scene, Volumes, Quad };

/// The light that a pass adds: one component of eq. 2, or a substitute.
enum class Shade { None, Id, Lit, Ambient, Diffuse, Specular, Reflection, Black, VertexColor };

enum class Stencil { Off, Increment, Decrement, OutsideShadow };
enum class Fog { Off, Colored, Black };

struct Pass {
    Geometry geometry = Geometry::Scene;
    Shade shade = Shade::None;
    bool textured = false;
    int light = 0;
    DepthState depth{true, DepthFunc::Equal, false};
    BlendState blend{true, BlendFactor::One, BlendFactor::One};
    Stencil stencil = Stencil::Off;
    Fog fog = Fog::Off;
    dmat4 eye_from_quad{1};
};

/// One frame: its passes for each jittered sample; more than one are accumulated.
struct Workload {
    std::string key, name;
    double wanted = 0;  ///< a peer's time over ours
    bool fill = false;  ///< in fill_frame() instead of scene_frame()
    std::vector<Pass> passes;
    std::vector<JitterState> samples{{0, 0}};
};

/// The table of docs/performance.md, "Against peers".
std::span<const Workload> workloads();

}  // namespace gw::peers
