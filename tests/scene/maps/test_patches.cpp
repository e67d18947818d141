// Claims: a map that lies on a mesh by coordinates of its own is the same map on patches, at each point
// of each triangle, however it repeats.
#include "scene/maps/finish.h"
#include "scene/maps/patches.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

/// R grows with s, G with t: 16 texels wide and high.
TextureRef ramp() {
    std::vector<std::uint16_t> rgba;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (const int v : {x * 4000, y * 4000, 0, 0xFFFF}) rgba.push_back(std::uint16_t(v));
    return make_texture("ramp", 16, 16, rgba);
}

Scene patched(const std::vector<vec2>& st, std::size_t side, const Map& map) {
    Scene scene;
    Material m{.name = "wall"};
    m.map_Ke = {map};
    m.map_Ke[0].texture = ramp();
    m.map_Ke[0].patched =
        std::make_shared<const PatchedLookup>(PatchedLookup{Patches(st.size() / 3, side), st});
    scene.materials = {m};
    return scene;
}

/// R and G of the ramp there, in texels.
vec2 at(const Scene& scene, std::size_t triangle, std::size_t x, std::size_t y) {
    const Texture& texture = *scene.materials[0].map_Ke[0].texture;
    const Patches patches(triangle + 1 > 2 ? 4 : 2, 8);
    const std::size_t texel = 4 * ((patches.row(triangle) + y) * std::size_t(texture.width()) +
                                   patches.column(triangle) + x);
    const auto& rgba = texture.levels[0].rgba;
    return vec2(rgba[texel], rgba[texel + 1]) / 4000.0f;
}

}  // namespace

TEST(PatchedMap, IsItselfAtEachPointOfEachTriangle) {
    Scene scene = patched({{0.25f, 0.25f},
                           {0.5f, 0.25f},
                           {0.25f, 0.75f},  //
                           {0.5f, 0.25f},
                           {0.75f, 0.5f},
                           {0.5f, 0.5f}},
                          8, {});
    Warnings warnings;
    finish(scene, warnings);
    EXPECT_TRUE(warnings.lines().empty());
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 8; ++x) {
            const double i = double(x) / 7, j = double(y) / 7;
            // A coordinate c is 16 c - 0.5 of the ramp's steps.
            EXPECT_NEAR(at(scene, 0, x, y).x, 16 * (0.25 + 0.25 * i) - 0.5, 0.001);
            EXPECT_NEAR(at(scene, 0, x, y).y, 16 * (0.25 + 0.5 * j) - 0.5, 0.001);
            EXPECT_NEAR(at(scene, 1, x, y).x, 16 * (0.5 + 0.25 * i) - 0.5, 0.001);
            EXPECT_NEAR(at(scene, 1, x, y).y, 16 * (0.25 + 0.25 * i + 0.25 * j) - 0.5, 0.001);
        }
    const Map& map = scene.materials[0].map_Ke[0];
    EXPECT_EQ(map.wrap_s, Wrap::Clamp);
    EXPECT_FALSE(map.patched);
}

TEST(PatchedMap, IsScaledMovedRepeatedAndMirroredBefore) {
    // s is 1.25 to 1.5; t, twice as long and moved by 1, 1.5 to 2 and mirrored.
    Scene scene = patched({{1.25f, 0.25f}, {1.5f, 0.25f}, {1.25f, 0.5f}, {0, 0}, {0, 0}, {0, 0}}, 8,
                          {.wrap_t = Wrap::MirroredRepeat, .offset = {0, 1}, .scale = {1, 2}});
    Warnings warnings;
    finish(scene, warnings);
    for (std::size_t k = 0; k < 7; ++k) {
        EXPECT_NEAR(at(scene, 0, k, 0).x, 16 * (0.25 + 0.25 * double(k) / 7) - 0.5, 0.001);
        EXPECT_NEAR(at(scene, 0, 0, k).y, 16 * (0.5 - 0.5 * double(k) / 7) - 0.5, 0.001);
    }
}

TEST(PatchedMap, ThatHasMoreTexelsThanItsPatchIsTheirMeanWithAWarning) {
    Scene scene = patched({{0, 0}, {7, 0}, {0, 7}, {0, 0}, {0, 0}, {0, 0}}, 8, {});
    Warnings warnings;
    finish(scene, warnings);
    ASSERT_EQ(warnings.lines().size(), 1u);
    EXPECT_NE(
        warnings.lines()[0].find("drawn with 8 texels along a triangle; expected at least 128"),
        std::string::npos)
        << warnings.lines()[0];
    EXPECT_NEAR(at(scene, 0, 3, 3).x, 7.5, 0.6);  // a texel of the patch is the ramp once
}

/// Within a triangle, bilinear filters read no other patch of level 1 either, where 16 texels are one.
TEST(PatchedMap, HasAMarginForSmallerLevels) {
    const Patches patches(2, 32);
    EXPECT_LE(patches.st(0, 1).x * 32 + 0.5f, 16);
    EXPECT_GE(patches.st(1, 0).x * 32 - 0.5f, 16);
    Scene scene =
        patched({{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}, {0, 0}, {0, 0}, {0, 0}}, 32, {});
    Warnings warnings;
    finish(scene, warnings);
    const Texture& texture = *scene.materials[0].map_Ke[0].texture;
    EXPECT_NEAR(texture.levels.at(1).rgba[4 * 15] / 4000.0, 16 * 0.75 - 0.5, 0.3);
}

TEST(PatchedMap, SidesArePowersOfTwoThatFit) {
    EXPECT_EQ(patch_side(1, 1u << 25), 2048u);
    EXPECT_EQ(patch_side(12, 1u << 25), 512u);
    EXPECT_EQ(patch_side(12, 1u << 18), 128u);
    EXPECT_EQ(patch_side(1u << 18, 1u << 25), 4u);
    EXPECT_EQ(patch_side((1u << 18) + 1, 1u << 25), 0u);
}

}  // namespace gw::scene
