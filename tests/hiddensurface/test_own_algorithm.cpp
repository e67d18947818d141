// Claim: the lecture's example of an own algorithm (docs/lecture.md, "Your own"), which is
// examples/hidden_surfaces/mine.cpp, does what it says.
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::hiddensurface {

TEST(OwnAlgorithm, ShowsWhatIsFarthest) {
    Trial trial(random_layers(1, 16), vgx(), 16, 12);
    StepLog log(Level::Polygon);
    Result result = run_on(*trial.machine, mine(), trial.input, log);
    compare(result, trial.z_buffer.ids, trial.input);
    const auto& polygons = trial.input.polygons;
    const auto farthest =
        std::max_element(polygons.begin(), polygons.end(),
                         [](const auto& a, const auto& b) { return a.farthest < b.farthest; });
    EXPECT_EQ(result.ids, std::vector<std::uint32_t>(16 * 12, farthest->id));
    EXPECT_EQ(result.counts.wrong, 16u * 12u);
    EXPECT_GT(result.counts.keys, 15u);
    EXPECT_EQ(log.steps().size(), 16u);
}

}  // namespace gw::hiddensurface
