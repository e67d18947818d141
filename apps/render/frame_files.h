// One frame of a drawing as files: picture, components, planes, manifest, counters. All or none
// appear. Does not parse options.
#pragma once

#include "apps/render/picture_options.h"
#include "apps/render/renderers.h"
#include "image/picture.h"

#include <filesystem>

namespace gw::apps {

/// Names of files and folders; an empty one is not wanted.
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

/// The passes that draw it: the scene's own in place of multipass's.
multipass::PassList passes_of(const Drawing& drawing);

/// Draws the picture: `samples` times, superposed.
void draw(const Drawing& drawing, const scene::View& view, Machine& machine);

/// Throws Error; then none of the files is there that was not before.
void draw_frame(const Drawing& drawing, const FrameFiles& files, const Session& session);

}  // namespace gw::apps
