// Claims: physically based surfaces become words that the machine takes, and the light that they
// reflect stays what glTF says. The encoding is written anew, in the library's functions.
#include "scene/maps/physical.h"

#include "scene/maps/mean.h"
#include "tests/gw/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::scene {
namespace {

double srgb_of(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Grey columns of these values.
Map columns(const std::vector<double>& values) {
    std::vector<std::uint16_t> rgba;
    for (const double v : values)
        for (const double c : {v, v, v, 1.0}) rgba.push_back(std::uint16_t(std::lround(c * 65535)));
    return {.texture = make_texture("columns", int(values.size()), 1, rgba)};
}

}  // namespace

/// From none to that of a metal: the exponent is one of MTL, and without a peak there is none.
TEST(Physical, HighlightsOfEveryStrengthHaveAnExponent) {
    test::Random random(3);
    for (const double strength : {0.0, 1e-9, 1e-6, 1e-3, 0.04, 1.0})
        for (int i = 0; i < 2000; ++i) {
            const auto color = [&] {
                return dvec3(random.fraction(), random.fraction(), random.fraction());
            };
            const dvec3 F0 = color() * strength, diffuse = color();
            const double roughness = random.one_in(4) ? 1 : double(random.fraction());
            const Highlight h = highlight_of(F0, diffuse, roughness);
            ASSERT_TRUE(h.Ns >= 0 && h.Ns <= 10000) << h.Ns << " of " << strength;
            for (int k = 0; k < 3; ++k) ASSERT_GE(h.Ks[k], 0);
            ASSERT_TRUE(strength != 0 || h.Ns == 0);
        }
}

/// A metal by F0 is the metal by its base colour, and is as bright under light from all sides.
TEST(Physical, AMetalIsTheSameByF0) {
    const dvec3 gold(1, 0.77, 0.34);
    Material by_base, by_F0;
    set_words({.base = gold, .metallic = 1, .roughness = 0.4}, by_base);
    set_words({.base = dvec3(0), .F0 = gold, .roughness = 0.4}, by_F0);
    EXPECT_NEAR(by_base.Ka.y, srgb_of(0.77), 1e-6);
    EXPECT_EQ(by_F0.Ka, by_base.Ka);
    EXPECT_EQ(by_F0.Kd, by_base.Kd);
    EXPECT_EQ(by_F0.Ks, by_base.Ks);
    EXPECT_EQ(by_F0.Ns, by_base.Ns);
}

TEST(Physical, NothingReflectsMoreThanAllOfTheLight) {
    Material m;
    set_words({.base = dvec3(1), .F0_tint = dvec3(1000), .metallic = 0}, m);
    EXPECT_EQ(m.Ka, vec3(1));
}

TEST(Reflectance, IsKdTimesTheMeanOfItsMap) {
    Material m{.Kd = vec3(0.5f, 0.25f, 1)};
    EXPECT_EQ(reflectance_of(m), dvec3(0.5, 0.25, 1));
    m.map_Kd = {columns({0.2, 0.4, 0.6, 0.4})};
    const dvec3 found = reflectance_of(m);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], 0.4 * double(m.Kd[k]), 1e-5);
    m.map_Kd[0].texture = nullptr;  // a picture that is not loaded
    EXPECT_EQ(reflectance_of(m), dvec3(0.5, 0.25, 1));
}

TEST(Reflectance, OfGltfIsProportionalToLight) {
    Material m;
    set_words(Physical{.base = dvec3(0.5, 0.1, 1), .metallic = 0}, m);
    EXPECT_NEAR(double(m.Kd.x), srgb_of(0.5), 1e-6);
    m.map_Kd = {columns({srgb_of(0.2), srgb_of(0.8)})};
    const dvec3 found = reflectance_of(m);
    EXPECT_NEAR(found.x, 0.25, 1e-4);
    EXPECT_NEAR(found.y, 0.05, 1e-4);
    EXPECT_NEAR(found.z, 0.5, 1e-4);
}

}  // namespace gw::scene
