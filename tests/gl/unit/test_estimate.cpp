// The estimated time of a frame on a VGX, by the prices of inspect/report/prices/vgx.toml.
#include "gl/record/estimate.h"

#include <gtest/gtest.h>

namespace gw::gl {

// A primitive takes 1000 ns (500 to 4000), a fragment 25 (12.5 to 100), a texel 8.45 (4 to 17), a
// pixel of a clear 0.625 (0.625 to 50).
TEST(Estimate, OfAFrameIsThatOfItsSlowerStage) {
    const auto of = [](std::uint64_t primitives, std::uint64_t fragments, std::uint64_t texels,
                       std::uint64_t pixels) {
        Counters frame;
        frame.primitives = primitives;
        frame.fragments = fragments;
        frame.texels = texels;
        frame.pixels = pixels;
        return estimated_on_vgx(frame);
    };
    EXPECT_DOUBLE_EQ(of(0, 0, 0, 0).seconds, 0);
    const Estimate geometry = of(5000, 10000, 0, 0);
    EXPECT_DOUBLE_EQ(geometry.seconds, 5000e-6);
    EXPECT_DOUBLE_EQ(geometry.least, 2500e-6);
    EXPECT_DOUBLE_EQ(geometry.most, 20000e-6);
    const Estimate pixels = of(100, 200000, 80000, 1000000);
    EXPECT_DOUBLE_EQ(pixels.seconds, (200000 * 25 + 80000 * 8.45 + 1000000 * 0.625) / 1e9);
    EXPECT_DOUBLE_EQ(pixels.least, (200000 * 12.5 + 80000 * 4.0 + 1000000 * 0.625) / 1e9);
    EXPECT_DOUBLE_EQ(pixels.most, (200000 * 100.0 + 80000 * 17.0 + 1000000 * 50.0) / 1e9);
}

TEST(Estimate, IsOfTheListsMachine) {
    EXPECT_EQ(std::string(estimated_machine()).find("IRIS 4D/340 VGX"), 0u);
}

}  // namespace gw::gl
