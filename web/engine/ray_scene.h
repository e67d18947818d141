// A scene for rays [K4, L9], without superposed effects, as `gw compare` draws it. It draws the
// passes of eq. 5 with their item buffer and the ordinary ray tracer, and follows one ray. Keeps
// what does not depend on the eye. Does not shade or trace: itembuffer/ and raytrace/ do.
#pragma once

#include "itembuffer/render.h"
#include "raytrace/tracer/render.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gw::lab {

class RayScene {
public:
    using Json = nlohmann::ordered_json;

    /// The machine must outlive it. `depth` as raytrace::TraceOptions has it.
    RayScene(Machine& machine, scene::Scene scene, int depth);
    RayScene(const RayScene&) = delete;

    /// Leaves the picture of eq. 5 in the machine. Answers `counts` of rays, `milliseconds`, of them
    /// `tracing`, and whether what no eye changes was `made` in that time.
    Json by_passes(const scene::View& view);
    /// The ordinary ray tracer's picture of the same view.
    Json by_rays(const scene::View& view);
    /// The identifiers of the view, bottom row first: those that by_passes() traced, if it has drawn
    /// this view. Overwrites the machine's planes.
    const std::vector<std::uint32_t>& identify(const scene::View& view);
    /// For identify()'s view. 1: the pixel's polygon reflects or transmits.
    std::vector<std::uint8_t> traced();
    /// The rays of a pixel (row 0 at the top) of identify()'s view: from the item buffer, or as an
    /// ordinary ray tracer sends them.
    Json path(int x, int y, bool ordinary);

    const scene::Scene& scene() const { return scene_; }
    int depth() const { return depth_; }

private:
    struct Walk;
    /// Serves both renderers.
    const std::shared_ptr<const raytrace::World>& world();
    raytrace::TraceOptions options() const { return {.depth = depth_, .threads = 1}; }

    Machine& machine_;
    scene::Scene scene_;
    int depth_;
    raytrace::RayCounts counts_;
    double tracing_ = 0;         ///< milliseconds
    scene::View asked_, drawn_;  ///< by_passes()'s view, and as the passes drew it
    std::unique_ptr<multipass::Driver> driver_;
    std::shared_ptr<const raytrace::World> world_;
    scene::View view_;
    std::vector<std::uint32_t> ids_;
};

}  // namespace gw::lab
