// [L9]: no ray loses an interface, or meets one twice.
#include "tests/raytrace/closed_body_cases.h"

#include <gtest/gtest.h>

namespace gw::raytrace {
namespace {

TEST(ClosedBodies, AreEnteredAndLeftInTurn) {
    for (const ClosedBodyCase& c : closed_body_cases()) {
        const PathCounts counts = PathCounter(c.bodies.scene, 1).count(10'000);
        EXPECT_GT(counts.hits, counts.paths) << c.name;
        EXPECT_EQ(counts.violations, 0u) << c.name << ", of " << counts.hits << " hits";
        EXPECT_EQ(counts.caught, 0u) << c.name;
    }
}

}  // namespace
}  // namespace gw::raytrace
