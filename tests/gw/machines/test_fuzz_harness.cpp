// The fuzz harness itself: it finds an injected fault and names its place. Lists are valid and the
// same everywhere. Does not search the machines for faults: test_fuzz.cpp does.
#include "tests/fuzz/check/diversity.h"
#include "tests/fuzz/check/explain.h"
#include "tests/fuzz/run.h"

#include <gtest/gtest.h>

#include <set>

namespace gw::fuzz {
namespace {

const Suite& suite_named(std::string_view name) {
    for (const Suite& suite : suites())
        if (suite.name == name) return suite;
    throw std::runtime_error("no such suite");
}

/// A window of 4 x 4 and three draws of a square over its lower left quarter, each nearer than the
/// last.
Case three_draws() {
    Case c{.width = 4, .height = 4};
    State state;
    state.depth.test = true;
    c.list.add(SetState{state});
    c.list.add(Clear{.planes = all_planes, .depth = 1});
    for (const float z : {0.5f, 0.0f, -0.5f})
        c.list.add(Draw{
            .mesh = make_mesh({.primitive = Primitive::Quads,
                               .positions = {{-1, -1, z}, {0, -1, z}, {0, 0, z}, {-1, 0, z}}})});
    return c;
}

TEST(FuzzHarness, FindsOneFlippedBitAndNamesItsPlaceAndStage) {
    const Case c = three_draws();
    const auto failure = run_case(c, machine_named("reference"), machine_named("faulty-pixel"));
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->split, Split::Commands);
    EXPECT_EQ(failure->command, 4u);  // the third draw
    EXPECT_EQ(failure->difference.plane, Plane::Depth);
    EXPECT_EQ(failure->difference.pixel, ivec2(0, 0));
    EXPECT_EQ(failure->difference.a, "4194304");  // (1 - 0.5) / 2 * (2^24 - 1) = 4194303.75
    EXPECT_EQ(failure->difference.b, "4194305");
    const std::string why = explain_pixel(c, failure->command, failure->difference);
    EXPECT_NE(why.find("stage: depth"), std::string::npos) << why;
    EXPECT_NE(why.find("depth 4194304"), std::string::npos) << why;
}

TEST(FuzzHarness, FindsACounterThatIsOneTooLarge) {
    const auto failure =
        run_case(three_draws(), machine_named("reference"), machine_named("faulty-counter"));
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->command, 4u);
    EXPECT_EQ(failure->difference.what, "pass 0 '', counter fragments");
    EXPECT_EQ(failure->difference.a, "12");
    EXPECT_EQ(failure->difference.b, "13");
}

TEST(FuzzHarness, FindsAFaultThatShowsOnlyInWholeLists) {
    const auto failure =
        run_case(three_draws(), machine_named("reference"), machine_named("faulty-split"));
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->split, Split::Whole);
    EXPECT_EQ(failure->command, 4u);
    EXPECT_EQ(failure->difference.plane, Plane::Color);
}

TEST(FuzzHarness, FindsNothingBetweenTheReferenceAndItself) {
    EXPECT_FALSE(run_case(three_draws(), machine_named("reference"), machine_named("reference")));
}

TEST(FuzzHarness, SaysWhenListsAreTooUniform) {
    Diversity reached;
    const Suite& suite = suite_named("stencil");
    for (int i = 0; i < 20; ++i) {
        const Case c = three_draws();
        const auto machine = make_reference(c.profile, c.width, c.height);
        machine->execute(c.list);
        reached.add(c, *machine);
    }
    const std::string gaps = missing(reached, suite);
    EXPECT_EQ(gaps.find("plane depth"), std::string::npos) << gaps;
    EXPECT_NE(gaps.find("plane stencil varies in 0 of 20 lists"), std::string::npos) << gaps;
    EXPECT_NE(gaps.find("counter stencil_killed is 0"), std::string::npos) << gaps;
}

TEST(FuzzHarness, MakesTheSameNumbersEverywhere) {
    Random random(seed_of("blend", 7));
    EXPECT_EQ(random.next(), 0xd1e4df4bf78d04c2u);
    EXPECT_EQ(random.below(1000), 627);
    EXPECT_EQ(random.real(-1, 1), -0x1.10414c06a8590p-4);
}

/// Lists that share numbers would be nearly one list.
TEST(FuzzHarness, ListsShareNoNumbers) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t index = 0; index < 200; ++index) {
        Random random(seed_of("blend", index));
        for (int i = 0; i < 500; ++i)
            EXPECT_TRUE(seen.insert(random.next()).second) << index << " " << i;
    }
}

}  // namespace
}  // namespace gw::fuzz
