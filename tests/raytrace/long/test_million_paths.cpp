// [L9]: no ray loses an interface, or meets one twice: a million paths.
#include "tests/raytrace/closed_body_cases.h"

#include <gtest/gtest.h>

namespace gw::raytrace {
namespace {

TEST(ClosedBodies, AreEnteredAndLeftInTurnOnAMillionPaths) {
    auto cases = closed_body_cases();
    for (const ClosedBodyCase& c : cases) {
        const PathCounts counts = PathCounter(c.bodies.scene, 2).count(1'000'000 / cases.size());
        EXPECT_EQ(counts.violations, 0u) << c.name << ", of " << counts.hits << " hits";
        EXPECT_EQ(counts.caught, 0u) << c.name;
    }
}

}  // namespace
}  // namespace gw::raytrace
