#include "gw/error.h"
#include "gw/texture.h"

#include <gtest/gtest.h>

#include <random>

namespace gw {
namespace {

std::vector<std::uint16_t> grey(std::initializer_list<int> values) {
    std::vector<std::uint16_t> rgba;
    for (const int v : values)
        for (int c = 0; c < 4; ++c) rgba.push_back(static_cast<std::uint16_t>(v));
    return rgba;
}

std::vector<int> first_channel(const TextureLevel& level) {
    std::vector<int> values;
    for (std::size_t i = 0; i < level.rgba.size(); i += 4) values.push_back(level.rgba[i]);
    return values;
}

// [R5.4]
TEST(Texture, EightBitTexelsAreSpreadOverSixteen) {
    const std::vector<std::uint8_t> rgba{0, 1, 128, 255};
    EXPECT_EQ(make_texture8("t", 1, 1, rgba)->levels[0].rgba,
              (std::vector<std::uint16_t>{0, 257, 32896, 65535}));
}

TEST(Texture, PowersOfTwoAreTakenAsTheyStand) {
    const auto rgba = grey({1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_EQ(make_texture("t", 4, 2, rgba)->levels[0].rgba, rgba);
}

// [R10.6]
TEST(Texture, LevelsAreMeansDownToOneTexel) {
    const auto t = make_texture("t", 4, 2, grey({0, 4, 100, 100, 4, 3, 100, 101}));
    ASSERT_EQ(t->levels.size(), 3u);
    // 11/4 and 401/4, to nearest
    EXPECT_EQ(first_channel(t->levels[1]), (std::vector<int>{3, 100}));
    EXPECT_EQ(first_channel(t->levels[2]), (std::vector<int>{52}));  // 51.5, up
    EXPECT_EQ(t->levels[2].width, 1);
    EXPECT_EQ(t->levels[2].height, 1);
}

TEST(Texture, ASingleRowOrColumnIsHalvedAlongItself) {
    const auto row = make_texture("t", 4, 1, grey({1, 2, 10, 20}));
    ASSERT_EQ(row->levels.size(), 3u);
    EXPECT_EQ(first_channel(row->levels[1]), (std::vector<int>{2, 15}));
    EXPECT_EQ(first_channel(row->levels[2]), (std::vector<int>{9}));
    const auto column = make_texture("t", 1, 4, grey({1, 2, 10, 20}));
    EXPECT_EQ(column->levels[1].height, 2);
    EXPECT_EQ(first_channel(column->levels[1]), first_channel(row->levels[1]));
}

TEST(Texture, OtherSidesGrowToTheNextPowerOfTwo) {
    // 3 texels to 4: centres at 1/8, 3/8, 5/8, 7/8 of 3 texels lie at -1/8 (clamped), 5/8, 11/8,
    // 17/8 (clamped).
    const auto t = make_texture("t", 3, 1, grey({0, 800, 1600}));
    EXPECT_EQ(t->width(), 4);
    EXPECT_EQ(t->height(), 1);
    EXPECT_EQ(first_channel(t->levels[0]), (std::vector<int>{0, 500, 1100, 1600}));
}

// [R10.7]
TEST(Texture, ResamplingIsExactBilinearToNearest) {
    std::mt19937 random(5);
    const int w = 5, h = 3;
    std::vector<std::uint16_t> rgba(4 * w * h);
    for (auto& v : rgba) v = static_cast<std::uint16_t>(random());
    const auto t = make_texture("t", w, h, rgba);
    ASSERT_EQ(t->width(), 8);
    ASSERT_EQ(t->height(), 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 4; ++c) {
                const double sx =
                    std::min(std::max((x + 0.5) * w / 8 - 0.5, 0.0), w - 1.0);  // exact in double
                const double sy_times_8 =
                    std::min(std::max((y + 0.5) * h * 2 - 4, 0.0), 8.0 * (h - 1));
                const int x0 = static_cast<int>(sx), y0 = static_cast<int>(sy_times_8 / 8);
                const double fx = sx - x0, fy = sy_times_8 / 8 - y0;
                const auto at = [&](int i, int j) {
                    return double{static_cast<double>(
                        rgba[std::size_t(4 * (std::min(j, h - 1) * w + std::min(i, w - 1)) + c)])};
                };
                const double value = (at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx) * (1 - fy) +
                                     (at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx) * fy;
                EXPECT_EQ(t->levels[0].rgba[std::size_t(4 * (y * 8 + x) + c)],
                          static_cast<int>(value + 0.5));
            }
}

TEST(Texture, AConstantStaysConstantInEverySize) {
    for (const int size : {1, 3, 5, 7, 100, 333}) {
        const std::vector<std::uint16_t> rgba(std::size_t(4 * size * 2), 65535);
        const TextureRef texture = make_texture("t", size, 2, rgba);
        for (const TextureLevel& level : texture->levels)
            for (const std::uint16_t v : level.rgba) ASSERT_EQ(v, 65535);
    }
}

TEST(Texture, ErrorsNameTheTexture) {
    const auto error = [](int w, int h, std::size_t values) -> std::string {
        try {
            make_texture("wood.png", w, h, std::vector<std::uint16_t>(values));
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_EQ(error(0, 4, 0), "texture wood.png: 0x4 texels; expected sides of 1 to 4096");
    EXPECT_EQ(error(4097, 1, 4 * 4097),
              "texture wood.png: 4097x1 texels; expected sides of 1 to 4096");
    EXPECT_EQ(error(2, 2, 12), "texture wood.png: 12 values for 2x2 texels of 4");
    EXPECT_EQ(error(4096, 1, 4 * 4096), "");
}

}  // namespace
}  // namespace gw
