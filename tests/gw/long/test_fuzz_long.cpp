// 5,000 random lists of each suite: both machines agree in every plane, counter, read-back and
// digest after every command. tests/gw/machines/test_fuzz.cpp has the first 100 of each suite.
#include "tests/fuzz/check/explain.h"

#include <gtest/gtest.h>

namespace gw::fuzz {

void PrintTo(const Suite& suite, std::ostream* out) { *out << suite.name; }

namespace {

class Fuzz : public testing::TestWithParam<Suite> {};

TEST_P(Fuzz, BothMachinesAgreeOn5000Lists) { EXPECT_EQ(disagreement(GetParam(), 100, 5100), ""); }

std::string name_of_suite(const testing::TestParamInfo<Suite>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Suites, Fuzz, testing::ValuesIn(suites()), name_of_suite);

}  // namespace
}  // namespace gw::fuzz
