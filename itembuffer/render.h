// Eq. 5 [K4]: multi-pass rendering with the traced component as one of its passes. Does not choose
// the other passes.
#pragma once

#include "multipass/frame/driver.h"
#include "raytrace/tracer/tracer.h"

#include <memory>
#include <optional>

namespace gw::itembuffer {

struct Options {
    int depth = 2;  ///< raytrace::TraceOptions::depth
    /// Hits of traced rays read shadow maps; else they send shadow rays.
    bool shadow_maps = false;
    /// The background of rays that leave the scene; absent: the scene's.
    std::optional<vec3> background;
    int threads = 0;                        ///< of the tracer; 0: all
    raytrace::RayCounts* counts = nullptr;  ///< the counts of all samples are added here
    /// Of the scene, if it is at hand; serves until an object moves. Null: made.
    std::shared_ptr<const raytrace::World> world = nullptr;
};

/// The passes of a scene with the traced component among them: after the opaque components, before
/// translucent passes and before fog's second step.
multipass::PassList passes_with_tracing(const scene::Scene& scene,
                                        multipass::Translucency translucency);

/// multipass::render of eq. 5; of eq. 2 and 4 if no material of the scene is traced.
multipass::Superposition render(Machine& machine, const scene::Scene& scene,
                                const scene::View& view, const multipass::Options& passes,
                                const Options& options = {});

/// The driver of `render`, for one view after the other. Keeps all data that no view changes, among
/// it hierarchies and shadow maps of reflected hits. The machine must outlive it.
std::unique_ptr<multipass::Driver> make_driver(Machine& machine, const scene::Scene& scene,
                                               const multipass::Options& passes,
                                               const Options& options = {});

/// multipass::Options::trace for the samples of `scene`. The passes draw raytrace::drawn_scene of
/// it. Keeps hierarchies from sample to sample as long as no object moves.
multipass::Trace tracing(const scene::Scene& scene, const Options& options);

}  // namespace gw::itembuffer
