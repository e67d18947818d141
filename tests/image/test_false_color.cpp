// Claims: false colours tell the values of depth, stencil, identifiers and accumulation apart.
#include "image/plane_pictures.h"

#include <gtest/gtest.h>

#include <set>

namespace gw::image {

using Values = std::vector<std::uint16_t>;

TEST(DepthColors, GoFromRedAtTheNearestToBlueAtTheFarthestThatOccurs) {
    const std::uint32_t nothing = (1u << 24) - 1;
    const Picture picture = depth_colors({1000, 2000, 3000, nothing}, 4, 1, 24);
    EXPECT_EQ(picture.values, (Values{255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}));
}

TEST(DepthColors, AreDefinedForOneDepthAndForAll32Bits) {
    EXPECT_EQ(depth_colors({5, 5}, 2, 1, 32).values, (Values{255, 0, 0, 255, 0, 0}));
    EXPECT_EQ(depth_colors({0, 0xfffffffe}, 2, 1, 32).values, (Values{255, 0, 0, 0, 0, 255}));
    EXPECT_EQ(depth_colors({0xffffffff}, 1, 1, 32).values, (Values{0, 0, 0}));
}

TEST(StencilColors, ShowZeroAloneAsBlack) {
    std::vector<std::uint8_t> all(256);
    for (std::size_t i = 0; i < 256; ++i) all[i] = static_cast<std::uint8_t>(i);
    const Picture picture = stencil_colors(all, 256, 1);
    for (std::size_t i = 0; i < 256; ++i) {
        const bool black =
            picture.values[3 * i] + picture.values[3 * i + 1] + picture.values[3 * i + 2] == 0;
        EXPECT_EQ(black, i == 0) << i;
    }
}

TEST(IdColors, DifferForSixtyFourThousandIdsAndAreBlackForNone) {
    std::vector<std::uint32_t> ids(64000);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::uint32_t>(i);
    const Picture picture = id_colors(ids, 64000, 1, 0);
    std::set<std::array<std::uint16_t, 3>> colors;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        colors.insert(
            {picture.values[3 * i], picture.values[3 * i + 1], picture.values[3 * i + 2]});
    }
    EXPECT_EQ(colors.size(), ids.size());
    EXPECT_EQ(picture.values[0] + picture.values[1] + picture.values[2], 0);
}

TEST(AccumColors, ShowFractionsOfTheLargestMagnitude) {
    const Picture picture = accum_colors({{510, 0, -255, 7}, {255, 1, 0, 7}}, 2, 1);
    EXPECT_EQ(picture.values, (Values{255, 0, 0, 128, 1, 0}));
}

TEST(ChangePicture, AmplifiesEveryChannelByWhatTheGreatestAllows) {
    const Picture before{2, 1, 3, 8, {10, 20, 30, 0, 0, 0}};
    const Picture after{2, 1, 3, 8, {10, 0, 70, 0, 1, 0}};
    EXPECT_EQ(change_picture(before, before).times, 255);
    const Change change = change_picture(before, after);
    EXPECT_EQ(change.times, 6);  // 255 / 40
    EXPECT_EQ(change.picture.values, (Values{0, 120, 240, 0, 6, 0}));
}

}  // namespace gw::image
