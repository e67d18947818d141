// Claims: the scenes of docs/lecture.md show what the page says.
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::hiddensurface {

// No two bars lie across each other's plane: the marks come before the only cut.
TEST(Lessons, BarsAreACycleThatOnlyTheMarksFind) {
    for (const auto& [name, bars] : {std::pair("pinwheel", 4u), std::pair("three_bars", 3u)}) {
        Trial trial(case_scene(name), vgx(), 320, 240);
        StepLog log(Level::Polygon);
        const Result result = trial.run("newell", log);
        EXPECT_EQ(result.counts.splits, 1u) << name;
        EXPECT_EQ(result.counts.wrong, 0u) << name;
        const auto& steps = log.steps();
        const auto cycle = std::find_if(steps.begin(), steps.end(),
                                        [](const Step& step) { return step.test == "marks"; });
        ASSERT_NE(cycle, steps.end()) << name;
        EXPECT_EQ(cycle->result, "cycle") << name;
        EXPECT_EQ(cycle->pieces.size(), bars) << name;
        EXPECT_TRUE(std::none_of(steps.begin(), cycle, [](const Step& step) {
            return step.action == Action::Split;
        })) << name;
        EXPECT_GT(trial.run("painter-farthest").counts.wrong, 100u) << name;
        if (bars == 4) {
            EXPECT_EQ(cycle - steps.begin() + 1, 63);
        }
    }
}

TEST(Lessons, RingIsNearlyRightAloneAndWrongWithABall) {
    Trial ring(case_scene("ring"), vgx(), 320, 240);
    EXPECT_EQ(ring.run("back-face").counts.wrong, 2u);
    Trial both(case_scene("ring_and_ball"), vgx(), 320, 240);
    EXPECT_EQ(both.run("back-face").counts.wrong, 306u);
}

TEST(Lessons, FiveForTheScanLineAndTenForWarnockAreRightWithFewSteps) {
    Trial five(case_scene("five"), vgx(), 64, 48), ten(case_scene("ten"), vgx(), 128, 96);
    EXPECT_EQ(five.input.polygons.size(), 5u);
    EXPECT_EQ(ten.input.polygons.size(), 10u);
    StepLog spans(Level::Span), windows(Level::Polygon);
    EXPECT_EQ(five.run("scan-line", spans).counts.wrong, 0u);
    EXPECT_EQ(ten.run("warnock", windows).counts.wrong, 0u);
    EXPECT_LT(spans.steps().size(), 300u);
    EXPECT_LT(windows.steps().size(), 1100u);
    const auto seen = [](const Trial& trial, std::uint32_t id) {
        const auto& ids = trial.z_buffer.ids;
        return std::count(ids.begin(), ids.end(), id) > 0;
    };
    EXPECT_FALSE(seen(five, 5)) << "the fifth is hidden";
    for (std::uint32_t id = 1; id <= 10; ++id) EXPECT_TRUE(seen(ten, id)) << id;
}

}  // namespace gw::hiddensurface
