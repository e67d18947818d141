// 100 random lists of each suite: both machines agree in every plane, counter, read-back and digest
// after every command. gw-fuzz and tests/gw/long run more.
#include "tests/fuzz/check/suite_test.h"

namespace gw::fuzz {
namespace {

TEST_P(Fuzz, BothMachinesAgreeOn100Lists) { EXPECT_EQ(disagreement(GetParam(), 0, 100), ""); }

INSTANTIATE_TEST_SUITE_P(Suites, Fuzz, testing::ValuesIn(suites()), name_of_suite);

}  // namespace
}  // namespace gw::fuzz
