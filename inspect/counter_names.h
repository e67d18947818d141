// The names of the counters, for tables, CSV and JSON. docs/manual.md, "Counters", says what they count.
#pragma once

#include "gw/machine.h"

#include <nlohmann/json.hpp>

#include <span>
#include <vector>

namespace gw::inspect {

struct CounterName {
    const char* name;
    std::uint64_t Counters::*count;
};

/// All of them, in the manual's order.
std::span<const CounterName> counter_names();

nlohmann::ordered_json json_of(const Counters& counters);

/// {"passes": how many ran, "by_name": [{"name", "runs", "counters"}] in the order of their first run,
/// "sum"}.
nlohmann::ordered_json totals_json(const std::vector<PassReport>& passes);

}  // namespace gw::inspect
