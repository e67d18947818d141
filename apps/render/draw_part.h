// One part of a picture that several processes draw. Does not parse options.
#pragma once

#include "apps/picture/picture_options.h"
#include "apps/render/part_file.h"

#include <filesystem>

namespace gw::apps {

/// Draws the rows of the share and writes them. Throws UsageError if the picture has fewer rows than
/// parts, Error if the file cannot be written.
void draw_part(const Drawing& drawing, const Share& share, const std::filesystem::path& file,
               const Session& session);

}  // namespace gw::apps
