// 5,000 random lists of each suite: both machines agree in every plane, counter, read-back and
// digest after every command. tests/gw/machines/test_fuzz.cpp has the first 100 of each suite.
#include "tests/fuzz/check/suite_test.h"

namespace gw::fuzz {
namespace {

TEST_P(Fuzz, BothMachinesAgreeOn5000Lists) { EXPECT_EQ(disagreement(GetParam(), 100, 5100), ""); }

INSTANTIATE_TEST_SUITE_P(Suites, Fuzz, testing::ValuesIn(suites()), name_of_suite);

}  // namespace
}  // namespace gw::fuzz
