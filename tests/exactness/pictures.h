// The fixed lists of the exactness table: shapes, all passes, each built-in profile, purely in
// code.
// Does not read files, and does not use the driver: the table must not change with the driver's
// choices.
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
