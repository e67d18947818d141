// The fixed lists of the exactness table: shapes and passes on each built-in profile, made in code.
// Does not read files or use the multi-pass driver, whose choices may change.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

#include <string>
#include <vector>

namespace gw::exactness {

struct Picture {
    std::string name;
    Profile profile;
    int width = 0, height = 0;
    CommandList list;
};

/// Every scene on every built-in profile.
std::vector<Picture> pictures();

}  // namespace gw::exactness
