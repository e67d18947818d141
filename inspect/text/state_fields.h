// The state's fields by name, with their values as text: "depth.func" "LEqual". Names are those of
// gw/state.h, words GL's. Does not choose fields.
#pragma once

#include "gw/state.h"

#include <string>
#include <utility>
#include <vector>

namespace gw::inspect {

struct Field {
    std::string name, value;
    bool operator==(const Field&) const = default;
};

/// All fields, in the order of gw/describe/state_fields.h.
std::vector<Field> fields(const State& state);
/// Those whose values differ from `before`'s.
std::vector<Field> changed_fields(const State& before, const State& state);

}  // namespace gw::inspect
