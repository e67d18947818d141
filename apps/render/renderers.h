// The renderers that gw knows, as a table: each draws a scene on a machine. To add one, add a row
// in renderers.cpp. Does not draw itself.
#pragma once

#include "gw/machine.h"
#include "itembuffer/render.h"
#include "multipass/frame/options.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

/// What the renderers are asked for besides the scene.
struct DrawOptions {
    /// `renderer` is the renderer's own; `passes`: in place of its list
    multipass::Options passes;
    itembuffer::Options rays;
    /// eq. 5: reflections of illum 3 and up by rays; false: reflection maps only
    bool traced = true;
};

struct Renderer {
    std::string name;
    std::string about;  ///< a few words for --help
    /// The picture is in the machine's colour plane afterwards; the view is as large as its window.
    std::function<void(Machine&, const scene::Scene&, const scene::View&, const DrawOptions&)> draw;
    /// Whose pass list it draws, where it draws one: only then there are passes and components to
    /// show.
    std::optional<multipass::Renderer> passes;
    /// Names of scene effects that it does not draw.
    std::vector<std::string> leaves_out{};
};

const std::vector<Renderer>& renderers();
/// By a name of renderer_names().
const Renderer& renderer_named(const std::string& name);
std::vector<std::string> renderer_names();
/// A line about the scene's effects that the renderer does not draw; empty: it draws all.
std::string left_out(const Renderer& renderer, const scene::Scene& scene);
/// The passes of a renderer that has them, for a scene: those of the options where they have any.
multipass::PassList pass_list(const Renderer& renderer, const scene::Scene& scene,
                              const DrawOptions& options);
/// "hardware: eq. 1 ...; multipass: ... (default)"
std::string renderers_help();

}  // namespace gw::apps
