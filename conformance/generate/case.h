// One case of a group: a profile, a window and a command list. Does not run it.
#pragma once

#include "conformance/generate/random.h"
#include "gw/command_list.h"
#include "gw/profile.h"

namespace gw::conformance {

/// A valid list with its profile and window.
struct Case {
    Profile profile;
    int width = 1, height = 1;
    CommandList list;
};

}  // namespace gw::conformance
