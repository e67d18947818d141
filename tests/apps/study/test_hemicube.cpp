// The study of hemicubes: errors fall with resolution, and oversampling misses nothing.
#include "apps/study/hemicube.h"

#include <gtest/gtest.h>

namespace gw::study {
namespace {

TEST(HemicubeStudy, ErrorsFallAndOversamplingMissesNothing) {
    const auto rows = hemicube_errors({16, 32, 64, 128}, 2, [](const std::string&) {});
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[1].pixels, 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].missed_oversampled, 0) << rows[i].size;
        EXPECT_LT(rows[i].rms_oversampled, rows[i].rms_drawn) << rows[i].size;
        const double before = i > 0 ? rows[i - 1].rms_drawn : 1e9;
        EXPECT_LT(rows[i].rms_drawn, before) << rows[i].size;
    }
    EXPECT_GT(rows[0].missed_drawn, 0.2);
    EXPECT_EQ(rows[3].missed_drawn, 0);
}

}  // namespace
}  // namespace gw::study
