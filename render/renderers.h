// The table of gw's renderers. Each draws a scene on a machine. To add one, add a row in
// renderers.cpp.
#pragma once

#include "gw/machine.h"
#include "itembuffer/render.h"
#include "multipass/frame/options.h"
#include "scene/draw/view.h"
#include "scene/scene.h"
#include "scene/validate/warnings_of.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gw::render {

/// The options of all renderers.
struct DrawOptions {
    /// `renderer` is the renderer's own; `pass_list` replaces its list
    multipass::Options multipass;
    itembuffer::Options rays;
    /// eq. 5: reflections of illum 3 and up by rays; false: reflection maps only
    bool traced = true;
};

struct Renderer {
    std::string name;
    std::string about;  ///< a few words for --help
    /// Leaves the picture in the machine's colour plane. The view is as large as its window.
    std::function<void(Machine&, const scene::Scene&, const scene::View&, const DrawOptions&)> draw;
    /// The owner of the pass list that it draws; none: it has no passes and components to show.
    std::optional<multipass::Renderer> pass_owner;
    /// Names of scene effects that it does not draw.
    std::vector<std::string> leaves_out{};
    scene::DrawnBy drawn_by = scene::DrawnBy::Passes;
};

const std::vector<Renderer>& renderers();
/// Throws OptionError if there is none of this name.
const Renderer& renderer_named(const std::string& name);
std::vector<std::string> renderer_names();
/// A line that names those of the effects that the scene has, "gw cast leaves out of this scene:
/// fog"; empty: it has none.
std::string left_out(const std::string& who, const std::vector<std::string>& effects,
                     const scene::Scene& scene);
/// The same for those that the renderer does not draw.
std::string left_out(const Renderer& renderer, const scene::Scene& scene);
/// What hidden-surface algorithms leave out: faces are opaque, seen from a point at an instant.
inline const std::vector<std::string> left_out_by_algorithms{"translucency", "motion", "aperture"};
/// The options' passes if they have any, else those of the renderer for the scene. The renderer
/// must have passes.
multipass::PassList pass_list(const Renderer& renderer, const scene::Scene& scene,
                              const DrawOptions& options);
/// "hardware: eq. 1 ...; multipass: ... (default)"
std::string renderers_help();

/// "fast", "reference": the default first.
std::vector<std::string> machines();

}  // namespace gw::render
