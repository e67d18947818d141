// The driver: a scene, a view and a pass list become command lists, executed on a machine.
// Does not read or write files, and touches no pixel itself: what it needs from the planes it reads with
// Read.
#pragma once

#include "gw/machine.h"
#include "multipass/passes.h"
#include "scene/scene.h"
#include "scene/view.h"

#include <optional>
#include <vector>

namespace gw::multipass {

/// Coincident faces added once. Auto counts winners first; Never and Always spare the count.
enum class OneWinner { Auto, Never, Always };

struct Options {
    Renderer renderer = Renderer::Multipass;
    std::optional<PassList> passes;  ///< in place of the renderer's
    OneWinner one_winner = OneWinner::Auto;
};

/// Draws the scene; the picture is in the machine's colour plane afterwards. The view is as large as the
/// machine's window. Throws Error where the profile cannot do what the scene asks for.
void render(Machine& machine, const scene::Scene& scene, const scene::View& view, const Options& options);

/// The list of one frame without effects that read pixels back: what `render` executes, in one piece.
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
