// A scene on a machine: everything that is made once and serves all of its superposed frames, and
// the drawing of one frame, with the read-backs that some effects need. Does not superpose
// (superpose.h) and does not choose passes (passes.h).
#pragma once

#include "gw/machine.h"
#include "multipass/frame/frame.h"
#include "multipass/frame/options.h"
#include "multipass/frame/samples.h"
#include "multipass/ties/tied_pixels.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::multipass {

class Picture {
public:
    /// Refers to the machine and the scene, which must outlive it.
    Picture(Machine& machine, const scene::Scene& scene, PassList passes, const Options& options,
            const vec3& background);
    Picture(const Picture&) = delete;

    /// Images that each frame adds in the accumulation buffer.
    int images() const { return images_of(steps_); }

    /// Draws the frame of one sample. The view is as large as the machine's window.
    void draw(const scene::View& view, const Sample& sample);

private:
    void move(const scene::View& view, const Sample& sample);
    bool attempt();
    void count_winners_of(Frame& frame, std::size_t end, TiedPixels& tied);
    void run(const Frame& frame, std::size_t first, std::size_t last);
    void run_layers(const Frame& frame, const LayerSteps& layers);
    bool wants_count() const;

    Machine& machine_;
    const scene::Scene& still_;
    scene::Scene now_;  ///< at the sample's moment; the model refers to it
    Options options_;
    vec3 background_;
    Model model_;
    std::vector<Step> steps_;
    std::vector<Topology> topologies_;
    Shadows shadows_;
    Stage stage_;
    std::vector<Rgba> traced_;
};

}  // namespace gw::multipass
