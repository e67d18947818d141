// A building at night with 100 lamps, as a TOML scene [K3.3]. Does not write files.
#pragma once

#include <string>

namespace gw::lamps {

/// The text of scenes/lamps.toml.
std::string building();

}  // namespace gw::lamps
