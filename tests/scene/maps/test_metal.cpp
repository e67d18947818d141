// Claims: where a map says metal, a surface is drawn as a metal by factor is, elsewhere as a dielectric;
// all of it with the map's mean roughness. The formulas are written anew, in the library's functions.
#include "scene/maps/finish.h"
#include "scene/maps/physical.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::scene {
namespace {

double srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

using Texel = std::array<double, 3>;

Map map_of(const std::vector<Texel>& texels) {
    std::vector<std::uint16_t> rgba;
    for (const Texel& texel : texels) {
        for (const double v : texel) rgba.push_back(std::uint16_t(std::lround(v * 65535)));
        rgba.push_back(0xFFFF);
    }
    return {.origin = {"m.gltf", 0},
            .texture = make_texture("texels", int(texels.size()), 1, rgba)};
}

/// A surface of this base colour with a map of G and B.
Scene surface(const dvec3& base, double roughness, const std::vector<Texel>& texels) {
    Scene scene;
    Material m{.name = "helmet"};
    m.map_metal = {map_of(texels)};
    m.physical = std::make_shared<const Physical>(
        Physical{.base = base, .metallic = 1, .roughness = roughness});
    scene.materials = {m};
    return scene;
}

std::vector<std::string> finished(Scene& scene) {
    Warnings warnings;
    finish(scene, warnings);
    return warnings.lines();
}

/// A word of the material times its map at a texel.
vec3 at(const vec3& word, const std::vector<Map>& map, std::size_t texel) {
    vec3 v = word;
    for (int k = 0; k < 3 && !map.empty(); ++k)
        v[k] *= float(map[0].texture->levels[0].rgba[4 * texel + std::size_t(k)]) / 65535.0f;
    return v;
}

#define EXPECT_NEAR_3(v, a, b, c) \
    EXPECT_NEAR((v).x, a, 1e-4);  \
    EXPECT_NEAR((v).y, b, 1e-4);  \
    EXPECT_NEAR((v).z, c, 1e-4)

}  // namespace

TEST(MetalMap, TexelsAreMetalOrADielectric) {
    Scene scene =
        surface({0.5, 0.25, 0.1}, 0.8, {{0, 1, 0}, {0, 0.5, 1}, {0, 0.75, 0.5}, {0, 0.75, 0}});
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    EXPECT_NEAR_3(at(m.Ka, m.map_Ka, 0), srgb(0.5), srgb(0.25), srgb(0.1));
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 0), srgb(0.5), srgb(0.25), srgb(0.1));
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 1), 0, 0, 0);
    const double rest = srgb(1 - 0.5);  // to a step of 255
    EXPECT_NEAR(at(m.Kd, m.map_Kd, 2).x, srgb(0.5) * rest, 0.003);
    // Roughness 0.8 * 0.75 = 0.6: a highlight F0 / (4 r^4) high.
    const double peak = 1 / (4 * std::pow(0.6, 4)), d = 0.04 * peak;
    EXPECT_NEAR_3(at(m.Ks, m.map_Ks, 0), srgb(0.5 + d) - srgb(0.5), srgb(0.25 + d) - srgb(0.25),
                  srgb(0.1 + d) - srgb(0.1));
    EXPECT_NEAR_3(at(m.Ks, m.map_Ks, 1), srgb(0.5 * peak), srgb(0.25 * peak), srgb(0.1 * peak));
    EXPECT_TRUE(m.map_metal.empty());
}

TEST(MetalMap, TheColoursOfTexelsMultiplyKdAndTheHighlightOfMetal) {
    Scene scene = surface(dvec3(0.5), 1, {{0, 0.5, 0}, {0, 0.5, 1}});
    scene.materials[0].map_Kd = {map_of({{0.5, 1, 0}, {0.5, 1, 0}})};
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    EXPECT_NEAR_3(at(m.Ka, m.map_Ka, 1), srgb(0.5) / 2, srgb(0.5), 0);
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 0), srgb(0.5) / 2, srgb(0.5), 0);
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 1), 0, 0, 0);
    EXPECT_NEAR_3(at(m.Ks, m.map_Ks, 1), 0.5, 1, 0);  // 0.5 / (4 / 16) is beyond white
}

TEST(MetalMap, AnEvenMapIsTheMaterialByFactor) {
    Scene scene = surface({0.5, 0.25, 0.1}, 1, {{0, 0.5, 1}, {0, 0.5, 1}});
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.Kd, vec3(0));
    EXPECT_TRUE(m.map_Kd.empty());
    EXPECT_TRUE(m.map_Ks.empty());
    EXPECT_NEAR_3(m.Ks, srgb(1), srgb(0.5), srgb(0.2));  // 0.5 / (4 / 16), and beyond white
}

TEST(MetalMap, AMapThatLiesInAnotherWayHasItsMeans) {
    Scene scene = surface(dvec3(0.5), 1, {{0, 0.5, 0}, {0, 0.5, 0.5}});
    scene.materials[0].map_Kd = {map_of({{1, 1, 1}})};
    scene.materials[0].map_Kd[0].scale = vec2(2);
    EXPECT_EQ(finished(scene),
              (std::vector<std::string>{
                  "m.gltf: material 'helmet': its metallicRoughnessTexture lies in another way "
                  "than its colours; expected the same, so it is drawn with its means"}));
    EXPECT_NEAR(scene.materials[0].Kd.x, srgb(0.5 * 0.75), 1e-4);
}

}  // namespace gw::scene
