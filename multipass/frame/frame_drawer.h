// Draws the frames of one scene on a machine, with the read-backs that some effects need. Keeps
// data that all superposed frames share. Does not superpose (superpose.h) and does not choose
// passes (passes.h).
#pragma once

#include "gw/machine.h"
#include "multipass/effects/one_winner.h"
#include "multipass/frame/frame.h"
#include "multipass/frame/options.h"
#include "multipass/frame/samples.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gw::multipass {

class FrameDrawer {
public:
    /// Refers to the machine and the scene, which must outlive it.
    FrameDrawer(Machine& machine, const scene::Scene& scene, PassList passes,
                const Options& options, const vec3& background);
    FrameDrawer(const FrameDrawer&) = delete;

    /// The number of images that each frame adds in the accumulation buffer.
    int images() const { return images_of(steps_); }

    /// Draws the frame of one sample. The view is as large as the machine's window.
    void draw(const scene::View& view, const Sample& sample);

private:
    void move(const scene::View& view, const Sample& sample);
    void clear_undrawn_rows();
    bool attempt();
    void count_winners_of(Frame& frame, std::size_t end, TiedPixels& tied);
    void run(const Frame& frame, std::size_t first, std::size_t last);
    void run_layers(const Frame& frame, const LayerSteps& layers);
    bool wants_count() const;
    FrameRules rules();

    Machine& machine_;
    const scene::Scene& still_;
    std::optional<scene::Scene> moving_;  ///< at the sample's moment; none: nothing moves
    const scene::Scene& now_;             ///< `moving_`, or `still_`; the model refers to it
    Options options_;
    vec3 background_;
    PassModel model_;
    std::vector<Step> steps_;
    std::vector<TopologyRef> topologies_;
    Shadows shadows_;
    PlacedModel placed_;
    std::vector<Rgba> traced_;
};

}  // namespace gw::multipass
