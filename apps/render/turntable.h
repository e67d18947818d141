// Pictures around a scene, one after the other on one machine. Does not parse options.
#pragma once

#include "apps/command/progress.h"
#include "apps/render/frame_files.h"

#include <utility>

namespace gw::apps {

/// Number first .. last of `pictures`, as IMAGE_001 ...; each is finished before the next is begun.
/// Throws Error.
void draw_turntable(Drawing& drawing, const FrameFiles& files, int pictures,
                    std::pair<int, int> first_last, Progress& progress, const Session& session);

}  // namespace gw::apps
