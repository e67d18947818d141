// 100 random lists of each suite: both machines agree in every plane, counter, read-back and digest
// after every command. gw-fuzz and tests/gw/long run more.
#include "tests/fuzz/check/explain.h"

#include <gtest/gtest.h>

namespace gw::fuzz {

void PrintTo(const Suite& suite, std::ostream* out) { *out << suite.name; }

namespace {

class Fuzz : public testing::TestWithParam<Suite> {};

TEST_P(Fuzz, BothMachinesAgreeOn100Lists) { EXPECT_EQ(disagreement(GetParam(), 0, 100), ""); }

std::string name_of_suite(const testing::TestParamInfo<Suite>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Suites, Fuzz, testing::ValuesIn(suites()), name_of_suite);

}  // namespace
}  // namespace gw::fuzz
