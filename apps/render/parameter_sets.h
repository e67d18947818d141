// The paper's parameter set of every pass that the driver runs, by the pass's name. Does not draw.
#pragma once

#include "apps/render/frame_files.h"

#include <map>
#include <string>

namespace gw::apps {

/// Empty for a renderer without passes; passes that the driver adds have none.
std::map<std::string, std::string> parameter_sets(const Drawing& drawing);

}  // namespace gw::apps
