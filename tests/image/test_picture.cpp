// A colour plane as a picture, and its tone.
#include "image/picture.h"

#include <gtest/gtest.h>

namespace gw::image {

TEST(Picture, OfAColourPlaneLeavesAlphaOut) {
    const Picture picture = picture_of({{1, 2, 3, 99}, {4, 5, 6, 99}}, 2, 1, 12);
    EXPECT_EQ(
        picture,
        (Picture{
            .width = 2, .height = 1, .channels = 3, .bits = 12, .values = {1, 2, 3, 4, 5, 6}}));
}

TEST(Tone, IsNothingUnlessAskedFor) {
    Picture picture{.width = 256, .height = 1, .channels = 1, .bits = 8, .values = {}};
    for (int v = 0; v < 256; ++v) picture.values.push_back(static_cast<std::uint16_t>(v));
    EXPECT_EQ(toned(picture, {}), picture);
}

TEST(Tone, ExposureOfOneStopDoublesAndClamps) {
    const Picture picture{
        .width = 4, .height = 1, .channels = 1, .bits = 8, .values = {0, 1, 127, 128}};
    EXPECT_EQ(toned(picture, {.exposure = 1}).values, (std::vector<std::uint16_t>{0, 2, 254, 255}));
}

TEST(Tone, GammaKeepsBlackAndWhiteAndLiftsTheMiddle) {
    const Picture picture{
        .width = 3, .height = 1, .channels = 1, .bits = 16, .values = {0, 16384, 65535}};
    // (16384/65535)^(1/2) 65535 = 32768.25
    EXPECT_EQ(toned(picture, {.gamma = 2}).values, (std::vector<std::uint16_t>{0, 32768, 65535}));
}

}  // namespace gw::image
