#include "image/textures.h"
#include "scenes/make_maps/maps.h"
#include "scenes/make_maps/noise.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace gw::maps {
namespace {

const std::filesystem::path folder = std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "maps";

class Maps : public testing::TestWithParam<NamedMap> {};

// If this fails after a change of a map: run make-maps scenes/maps.
TEST_P(Maps, CommittedTexelsAreThoseMadeAgain) {
    const image::Picture made = GetParam().picture();
    const TextureRef read = image::read_texture(folder / GetParam().file);
    ASSERT_EQ(read->width(), made.width);
    ASSERT_EQ(read->height(), made.height);
    for (std::size_t i = 0; i < made.values.size(); ++i)
        ASSERT_EQ(read->levels[0].rgba[i / 3 * 4 + i % 3], 257 * made.values[i]) << "value " << i;
}

INSTANTIATE_TEST_SUITE_P(All, Maps, testing::ValuesIn(maps()), [](const auto& test) {
    const std::string& file = test.param.file;
    return file.substr(0, file.find('.'));
});

TEST(Maps, TheFolderHasNoOthers) {
    std::set<std::string> files, named;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.insert(entry.path().filename().string());
    for (const NamedMap& map : maps()) named.insert(map.file);
    EXPECT_EQ(files, named);
}

// The map that turns the hardware's gloss red in Fig. 1b [K2]: almost no green and blue, much red.
TEST(Maps, TheRedMapIsRed) {
    const auto red = std::ranges::find(maps(), "red.png", &NamedMap::file)->picture();
    for (std::size_t i = 0; i < red.values.size(); i += 3) {
        ASSERT_GE(red.values[i], 170);
        ASSERT_LE(std::max(red.values[i + 1], red.values[i + 2]), 15);
    }
}

TEST(Noise, RepeatsAfterItsCells) {
    for (const double s : {0.0, 0.125, 0.3125, 0.75}) {
        EXPECT_EQ(noise({s, 0.5}, {8, 4}, 1), noise({s + 1, 0.5}, {8, 4}, 1));
        EXPECT_EQ(noise({s, 0.5}, {8, 4}, 1), noise({s, -0.5}, {8, 4}, 1));
        EXPECT_EQ(fractal({s, 0.25}, {2, 2}, 5, 3), fractal({s - 1, 1.25}, {2, 2}, 5, 3));
    }
}

TEST(Noise, ItsHashIsTheSameEverywhere) {
    EXPECT_EQ(hash(0, 0, 0), 0u);
    EXPECT_EQ(hash(1, 2, 3), 2902294105u);
    EXPECT_NE(hash(1, 2, 3), hash(2, 1, 3));
    std::set<std::uint32_t> distinct;
    for (std::uint32_t i = 0; i < 1000; ++i) distinct.insert(hash(i % 10, i / 10 % 10, i / 100));
    EXPECT_EQ(distinct.size(), 1000u);
}

}  // namespace
}  // namespace gw::maps
