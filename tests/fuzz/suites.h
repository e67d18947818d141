// The random lists of conformance/, as suites for tests: each list has an index.
// Does not run them.
#pragma once

#include "conformance/groups.h"

#include <cstdint>
#include <vector>

namespace gw::fuzz {

using namespace conformance;  // cases and their generators, for all tests with random lists

using Suite = conformance::Group;

/// The groups of random lists, in the order of conformance/groups.cpp.
const std::vector<Suite>& suites();

/// List `index` of a suite.
Case make_case(const Suite& suite, std::uint64_t index);

}  // namespace gw::fuzz
