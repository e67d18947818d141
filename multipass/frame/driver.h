// The driver: a scene, a view and options become a picture on a machine.
// Does not read or write files, and touches no pixel itself: what it needs from the planes it reads
// with Read.
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

/// A scene drawn from one view after the other. What the view does not decide is made once: meshes
/// of maps, shadow volumes, shadow maps.
class Drawer {
public:
    /// The machine must outlive it.
    Drawer(Machine& machine, scene::Scene scene, const Options& options);
    Drawer(const Drawer&) = delete;
    ~Drawer();

    /// The picture is in the machine's colour plane afterwards. The view is as large as the
    /// machine's window.
    /// Says how many pictures were superposed, in how many groups. Throws Error where the profile
    /// cannot do what is asked for.
    Superposition draw(const scene::View& view);

private:
    struct Ready;
    Machine& machine_;
    scene::Scene scene_;
    Options options_;
    PassList passes_;
    std::unique_ptr<Ready> ready_;
};

/// One view.
Superposition render(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     const Options& options);

/// The passes that `render` draws the scene with.
PassList pass_list(const scene::Scene& scene, const Options& options);

/// The list of one frame without effects that read pixels back (shadow maps, layers, counted
/// winners): what `render` executes, in one piece.
CommandList frame_list(const scene::Scene& scene, const scene::View& view, const PassList& passes,
                       const vec3& background, bool one_winner = false, int stencil_bits = 8);

/// One picture per component (Fig. 4).
struct ComponentImage {
    std::string name;
    std::vector<Rgba> color;  ///< bottom row first
};
std::vector<ComponentImage> render_components(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, const Options& options);

/// The passes of a scene as text, a line each, in the paper's notation.
std::string print_passes(const PassList& passes);

}  // namespace gw::multipass
