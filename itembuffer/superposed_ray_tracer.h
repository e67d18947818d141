// The ordinary ray tracer with superposed pictures: sub-pixel positions, lens, motion and soft
// lights, at the same samples as the passes. Leaves out glare. Does not trace
// (raytrace/tracer/render.h).
#pragma once

#include "itembuffer/render.h"

namespace gw::itembuffer {

/// Leaves the picture, the mean of at least `samples`, in the machine's colour plane. Ignores
/// Options::shadow_maps: an ordinary ray tracer has none.
multipass::Superposition superpose_ray_traced(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, int samples,
                                              const Options& options, bool weighted = false);

}  // namespace gw::itembuffer
