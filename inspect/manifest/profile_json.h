// A profile as JSON, its keys those of a profile's TOML file.
#pragma once

#include "gw/profile.h"

#include <nlohmann/json.hpp>

namespace gw::inspect {

nlohmann::ordered_json json_of(const Profile& profile);

}  // namespace gw::inspect
