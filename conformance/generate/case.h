// One case of a group: a profile, a window and a command list. Does not run it.
#pragma once

#include "conformance/generate/random.h"
#include "gw/command_list.h"
#include "gw/profile.h"
#include "inspect/shown/color_map.h"

#include <optional>
#include <vector>

namespace gw::conformance {

/// A list of its own from a command on, with the map through which a screen shows it; none: as before.
struct ShownFrom {
    std::size_t command = 0;
    std::optional<inspect::ColorMap> map;
};

/// A valid list with its profile and window.
struct Case {
    Profile profile;
    int width = 1, height = 1;
    CommandList list;
    std::vector<ShownFrom> maps{};  ///< in the order of their commands; machines do not know them
};

}  // namespace gw::conformance
