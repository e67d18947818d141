// The driver: a scene, a view and options become a picture on a machine. Does not read or write
// files. Touches no pixel itself: it reads planes by the command Read.
#pragma once

#include "gw/machine.h"
#include "multipass/frame/options.h"
#include "multipass/frame/superpose.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace gw::multipass {

/// Draws a scene from one view after the other. Makes data that no view changes once: meshes of
/// maps, shadow volumes, shadow maps.
class Driver {
public:
    /// The machine must outlive it.
    Driver(Machine& machine, scene::Scene scene, const Options& options);
    Driver(const Driver&) = delete;
    ~Driver();

    /// Leaves the picture in the machine's colour plane. The view is as large as the machine's
    /// window. Returns how many pictures were superposed, in how many groups. Throws Error if the
    /// profile cannot draw the scene.
    Superposition draw(const scene::View& view);

private:
    struct PreparedScene;
    Machine& machine_;
    scene::Scene scene_;
    Options options_;
    PassList passes_;
    std::unique_ptr<PreparedScene> prepared_;
};

/// One view.
Superposition render(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     const Options& options);

/// The passes that `render` draws the scene with.
PassList pass_list(const scene::Scene& scene, const Options& options);

/// The list of one frame in one piece, without the effects that read pixels back: shadow maps,
/// layers, counted winners.
CommandList frame_list(const scene::Scene& scene, const scene::View& view, const PassList& passes,
                       const vec3& background, bool one_winner = false, int stencil_bits = 8);

/// One picture per component (Fig. 4).
std::vector<ComponentImage> render_components(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, const Options& options);

/// The passes of a scene as text, a line each, in the paper's notation.
std::string print_passes(const PassList& passes);

}  // namespace gw::multipass
