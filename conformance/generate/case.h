// One case of a suite: a profile, a window and a command list. Does not run it.
#pragma once

#include "conformance/generate/random.h"
#include "gw/command_list.h"
#include "gw/counters.h"
#include "gw/profile.h"

#include <vector>

namespace gw::fuzz {

/// A valid list with its profile and window.
struct Case {
    Profile profile;
    int width = 1, height = 1;
    CommandList list;
};

using CounterField = std::uint64_t Counters::*;

/// A family of random lists. Over a long range, each plane of `planes` must vary within a picture
/// and each counter of `counters` must change, or the suite proves nothing.
struct Suite {
    const char* name;
    const char* about;
    Case (*make)(Random&);
    PlaneMask planes = mask_of(Plane::Color);
    std::vector<CounterField> counters;
};

/// All suites, in the order of conformance/suites.cpp.
const std::vector<Suite>& suites();

/// List `index` of a suite.
Case make_case(const Suite& suite, std::uint64_t index);

}  // namespace gw::fuzz
