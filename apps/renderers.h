// The renderers that gw knows, as a table: each draws a scene on a machine. To add one, add a row in
// renderers.cpp. Does not draw itself.
#pragma once

#include "gw/machine.h"
#include "multipass/options.h"
#include "scene/scene.h"
#include "scene/view.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

struct Renderer {
    std::string name;
    std::string about;  ///< a few words for --help
    /// The picture is in the machine's colour plane afterwards; the view is as large as its window. Of the
    /// options, `renderer` and `passes` are its own.
    std::function<void(Machine&, const scene::Scene&, const scene::View&, const multipass::Options&)> draw;
    /// Whose pass list it draws, where it draws one: only then there are passes and components to show.
    std::optional<multipass::Renderer> passes;
};

const std::vector<Renderer>& renderers();
/// By a name of renderer_names().
const Renderer& renderer_named(const std::string& name);
std::vector<std::string> renderer_names();
/// "hardware: eq. 1 ...; multipass: ... (default)"
std::string renderers_help();

}  // namespace gw::apps
