// A test with the suites of random lists as parameters: its class, and the suites' names.
#pragma once

#include "tests/fuzz/check/explain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

namespace gw::fuzz {

inline void PrintTo(const Suite& suite, std::ostream* out) { *out << suite.name; }

class Fuzz : public testing::TestWithParam<Suite> {};

inline std::string name_of_suite(const testing::TestParamInfo<Suite>& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace gw::fuzz
