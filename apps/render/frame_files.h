// One frame of a drawing as files: picture, components, planes, manifest, counters. All or none
// appear. Does not parse options.
#pragma once

#include "apps/picture/picture_options.h"
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

/// The file of a series: "rings.png" becomes "rings_007.png".
std::filesystem::path numbered(const std::filesystem::path& file, int number);

/// Warns of an empty picture unless quiet. Throws Error; then no new file exists.
void draw_frame(const Drawing& drawing, const FrameFiles& files, const Session& session,
                bool quiet);

}  // namespace gw::apps
