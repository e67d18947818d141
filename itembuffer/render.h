// Eq. 5 [K4]: multi-pass rendering with the traced component as one of its passes. Does not choose
// the other passes and does not read files.
#pragma once

#include "multipass/frame/driver.h"
#include "raytrace/tracer/tracer.h"

#include <optional>

namespace gw::itembuffer {

struct Options {
    int depth = 2;  ///< raytrace::TraceOptions::depth
    /// traced hits read the passes' shadow maps; else shadow rays
    bool shadow_maps = false;
    /// what rays see that leave the scene; absent: the scene's
    std::optional<vec3> background;
    int threads = 0;                        ///< of the tracer; 0: all
    raytrace::RayCounts* counts = nullptr;  ///< of all samples, added to
};

/// The passes of a scene with the traced component among them: after the opaque components, before
/// what is blended over them and before fog's second step.
multipass::PassList passes_with_tracing(const scene::Scene& scene,
                                        multipass::Translucency translucency);

/// multipass::render of eq. 5; of eq. 2 and 4 where no material of the scene asks for rays.
multipass::Superposition render(Machine& machine, const scene::Scene& scene,
                                const scene::View& view, const multipass::Options& passes,
                                const Options& options = {});

/// What draws the traced component of `scene`'s samples: multipass::Options::trace. The scene that
/// is drawn is raytrace::drawn_scene of it. Keeps hierarchies from sample to sample as long as no
/// object moves.
multipass::Trace tracing(const scene::Scene& scene, const Options& options);

}  // namespace gw::itembuffer
