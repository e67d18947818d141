// The pictures of a film, numbered files one after the other. Does not parse options.
#pragma once

#include "apps/render/frame_files.h"

#include <optional>
#include <utility>

namespace gw::apps {

class Progress;

struct FilmOptions {
    std::pair<int, int> first_last{1, 1};
    std::optional<double> rate, shutter;  ///< instead of the scene's
    std::optional<int> instants;
    bool go_on = false;  ///< begins at the first picture whose file is missing
};

/// Each picture is finished before the next is begun. The film is the drawing's. Throws Error.
void draw_film(Drawing& drawing, const FrameFiles& files, const FilmOptions& options,
               Progress& progress, const Session& session);

}  // namespace gw::apps
