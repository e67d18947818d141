// The manifest of a frame: what was drawn, and what the machine says of every pass. docs/commands.md,
// "Manifest". Does not name the machine or its threads: they make no difference, and two manifests can be
// compared as files.
#pragma once

#include "apps/frame_files.h"

#include <string>

namespace gw::apps {

/// JSON. `machine`: after the frame, drawn with digests of every pass.
std::string manifest(const Drawing& drawing, const scene::View& view, Machine& machine);

}  // namespace gw::apps
