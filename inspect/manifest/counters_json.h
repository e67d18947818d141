// Counters as JSON, by the names of gw/names.h.
#pragma once

#include "gw/counters.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace gw::inspect {

nlohmann::ordered_json json_of(const Counters& counters);

/// {"passes": how many ran, "by_name": [{"name", "runs", "counters"}] in the order of their first
/// run, "sum"}.
nlohmann::ordered_json totals_json(const std::vector<PassReport>& passes);

}  // namespace gw::inspect
