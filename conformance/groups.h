// The groups of generated command lists, one row each. Does not make recordings: suite.h does.
#pragma once

#include "conformance/generate/case.h"
#include "gw/counters.h"

#include <string>
#include <vector>

namespace gw::conformance {

using CounterField = std::uint64_t Counters::*;

/// Lists about one subject. Over a long range of random lists, each plane of `planes` must vary
/// within a picture and each counter of `counters` must change, or they prove nothing.
struct Group {
    std::string name;   ///< its recordings are "NAME_01", "NAME_02", ...
    std::string about;  ///< one line
    std::string rules;  ///< of the manual, which its recordings reach: "R6.15-R6.19 R9.4"
    Case (*make)(Random&);
    int count;             ///< of its recordings; 0: for random tests only
    PlaneMask planes = 0;  ///< 0: for recordings only
    std::vector<CounterField> counters{};
};

/// In the order of the manual's chapters.
const std::vector<Group>& all_groups();

}  // namespace gw::conformance
