// 2,100 random lists: machine against machine, every plane, counter, read-back and digest after every
// command. More of them: gw-fuzz, and tests/gw/long.
#include "tests/fuzz/diversity.h"
#include "tests/fuzz/run.h"

#include <gtest/gtest.h>

namespace gw::fuzz {

void PrintTo(const Suite& suite, std::ostream* out) { *out << suite.name; }

namespace {

std::string repeat(const Suite& suite, std::uint64_t i) {
    return "repeat: build/release/bin/gw-fuzz --suite " + std::string(suite.name) + " --range " +
           std::to_string(i) + " " + std::to_string(i + 1);
}

class Fuzz : public testing::TestWithParam<Suite> {};

TEST_P(Fuzz, BothMachinesAgreeOn100Lists) {
    const MachineMaker a = machine_named("reference"), b = machine_named("fast");
    Diversity reached;
    for (std::uint64_t i = 0; i < 100; ++i) {
        const Case c = make_case(GetParam(), i);
        const auto failure = run_case(c, a, b, [&](Machine& machine) { reached.add(c, machine); });
        ASSERT_FALSE(failure) << failure->difference.what << "\n" << repeat(GetParam(), i);
    }
    EXPECT_EQ(missing(reached, GetParam()), "");
}

std::string name_of_suite(const testing::TestParamInfo<Suite>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Suites, Fuzz, testing::ValuesIn(suites()), name_of_suite);

}  // namespace
}  // namespace gw::fuzz
