// Shadow maps for the hits of traced rays [K4i, K3.2 a]: instead of a shadow ray each, every light's
// Z-buffer, drawn by the machine as for the passes. Sees no better than the maps' texels. Does not serve
// first hits: the passes do.
#pragma once

#include "gw/machine.h"
#include "multipass/shadow_lookup.h"
#include "scene/scene.h"

#include <functional>

namespace gw::itembuffer {

/// Draws the maps of all lights that cast shadows and returns the question of raytrace::TraceOptions, which
/// may outlive everything here. `scene` is the drawn one.
std::function<bool(std::size_t, const scene::TrianglePoint&)> hit_shadows(Machine& machine,
                                                                          const scene::Scene& scene,
                                                                          int width, int height);

}  // namespace gw::itembuffer
