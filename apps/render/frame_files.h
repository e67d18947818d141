// A drawing, and one frame of it as files: picture, components, planes, manifest, counters. All or
// none appear. Does not parse options.
#pragma once

#include "apps/render/picture_options.h"
#include "apps/render/renderers.h"
#include "image/picture.h"

#include <filesystem>
#include <map>
#include <string>

namespace gw::apps {

/// Names of files and folders; empty: not wanted.
struct FrameFiles {
    std::filesystem::path picture, components, planes, manifest, counters;
    image::Tone tone;  ///< of the picture and the components
};

struct Drawing {
    const PictureOptions& options;
    const Renderer& renderer;
    Profile profile;
    scene::Scene scene;                             ///< with a camera
    std::optional<multipass::PassList> own_passes;  ///< the scene's
};

/// Reads scene and profile.
Drawing make_drawing(const PictureOptions& options, Session& session);

/// The passes that draw it. The scene's own replace those of multipass.
multipass::PassList passes_of(const Drawing& drawing);

/// Draws the picture: `samples` times, superposed.
void draw(const Drawing& drawing, const scene::View& view, Machine& machine);

/// Throws Error; then no new file exists.
void draw_frame(const Drawing& drawing, const FrameFiles& files, const Session& session);

/// The paper's parameter set of every pass that the driver runs, by the pass's name. Passes that the
/// driver adds have none. Empty for a renderer without passes.
std::map<std::string, std::string> parameter_sets(const Drawing& drawing);

}  // namespace gw::apps
