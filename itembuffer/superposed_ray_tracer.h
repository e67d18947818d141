// The ordinary ray tracer with what superposed pictures have: sub-pixel positions, lens, motion,
// soft lights, glare left out. The same samples as the passes'. Does not trace:
// raytrace/tracer/render.h does.
#pragma once

#include "itembuffer/render.h"

namespace gw::itembuffer {

/// The picture, the mean of at least `samples`, weighted or not, is in the machine's colour plane
/// afterwards.
/// Of the options `shadow_maps` is not heeded: an ordinary ray tracer has none.
multipass::Superposition render_by_rays(Machine& machine, const scene::Scene& scene,
                                        const scene::View& view, int samples,
                                        const Options& options, bool weighted = false);

}  // namespace gw::itembuffer
