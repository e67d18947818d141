// Counters and profiles as JSON.
#pragma once

#include "gw/counters.h"
#include "gw/profile.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace gw::inspect {

/// The first extensions of extension_names(), the papers', are always written; of the others those
/// that the profile has.
inline constexpr std::size_t always_named_extensions = 4;

/// Its keys are those of a profile's TOML file.
nlohmann::ordered_json json_of(const Profile& profile);

/// By the names of gw/names.h.
nlohmann::ordered_json json_of(const Counters& counters);

/// {"passes": how many ran, "by_name": [{"name", "runs", "counters"}] in the order of their first
/// run, "sum"}.
nlohmann::ordered_json totals_json(const std::vector<PassReport>& passes);

}  // namespace gw::inspect
