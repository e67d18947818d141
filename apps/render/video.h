// A video of pictures that are there, by the program ffmpeg. Does not draw.
#pragma once

#include "apps/command/command.h"

#include <filesystem>
#include <utility>

namespace gw::apps {

/// Throws UsageError unless GW knows the kind of video by the name's extension, Error if the file
/// cannot be written or ffmpeg is not there. Call it before long work.
void check_video(const std::filesystem::path& video);

/// Shows pictures IMAGE_001 ..., first to last, `rate` a second. The file appears whole or not at all.
/// Throws Error.
void make_video(const std::filesystem::path& video, const std::filesystem::path& picture,
                std::pair<int, int> first_last, double rate, const Session& session);

}  // namespace gw::apps
