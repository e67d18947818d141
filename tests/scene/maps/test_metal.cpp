// Claims: where a map says metal, a surface is drawn as a metal by factor is, elsewhere as a dielectric;
// all of it with the map's mean roughness, weighted by F0. The formulas are written anew, in the library's functions.
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

/// Kd and Ks of a metal: half the roughness is the share of its highlight that is in Kd.
double metal_Kd(double highlight, double roughness) { return highlight * roughness / 2; }
double metal_Ks(double highlight, double roughness) { return highlight * (1 - roughness / 2); }

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
    const dvec3 base(0.5, 0.25, 0.1);
    Scene scene = surface(base, 0.8, {{0, 1, 0}, {0, 0.5, 1}, {0, 0.75, 0.5}, {0, 0.75, 0}});
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    // Roughness 0.8, 0.4, 0.6, 0.6, each as often as its F0 in red says.
    const double r =
        (0.04 * 0.8 + 0.5 * 0.4 + 0.27 * 0.6 + 0.04 * 0.6) / (0.04 + 0.5 + 0.27 + 0.04);
    const double d = 0.04 / (4 * std::pow(r, 4));  // a highlight F0 / (4 r^4) high
    for (int k = 0; k < 3; ++k) {
        const double b = base[k], of_metal = srgb(b / 0.5);  // beyond white it keeps its hue
        EXPECT_NEAR(at(m.Ka, m.map_Ka, 0)[k], srgb(b + 0.04), 1e-4);
        EXPECT_NEAR(at(m.Kd, m.map_Kd, 0)[k], srgb(b), 1e-4);
        EXPECT_NEAR(at(m.Ks, m.map_Ks, 0)[k], srgb(b + d) - srgb(b), 1e-4);
        EXPECT_NEAR(at(m.Ka, m.map_Ka, 1)[k], srgb(b), 1e-4);
        EXPECT_NEAR(at(m.Kd, m.map_Kd, 1)[k], metal_Kd(of_metal, r), 1e-4);
        EXPECT_NEAR(at(m.Ks, m.map_Ks, 1)[k], metal_Ks(of_metal, r), 1e-4);
    }
    Material half;
    set_words({.base = base, .metallic = 0.5, .roughness = r}, half);
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 2), half.Kd.x, half.Kd.y, half.Kd.z);
    EXPECT_NEAR_3(at(m.Ks, m.map_Ks, 2), half.Ks.x, half.Ks.y, half.Ks.z);
    EXPECT_TRUE(m.map_metal.empty());
}

TEST(MetalMap, TheColoursOfTexelsAreThoseOfItsMetal) {
    Scene scene = surface(dvec3(0.5), 1, {{0, 0.5, 0}, {0, 0.5, 1}});
    scene.materials[0].map_Kd = {map_of({{0.4, 1, 0}, {0.4, 1, 0}})};
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    const double red = 0.5 * decoded(dvec3(0.4)).x;
    EXPECT_NEAR_3(at(m.Ka, m.map_Ka, 1), srgb(red), srgb(0.5), 0);
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 0), srgb(red), srgb(0.5), 0);
    const double r = 0.5, hue = srgb(red / 0.5);  // 0.5 / (4 r^4) is beyond white
    EXPECT_NEAR_3(at(m.Kd, m.map_Kd, 1), metal_Kd(hue, r), metal_Kd(1, r), 0);
    EXPECT_NEAR_3(at(m.Ks, m.map_Ks, 1), metal_Ks(hue, r), metal_Ks(1, r), 0);
}

/// A white factor has no highlight that could be seen, and the rough part is no mirror.
TEST(MetalMap, GoldBesideARoughDielectricShinesAsGold) {
    Scene scene = surface(dvec3(1), 1, {{0, 0.4, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}});
    const Texel gold{1, 0.9, 0.5}, dark{0, 0, 0};
    scene.materials[0].map_Kd = {map_of({gold, dark, dark, dark})};
    EXPECT_TRUE(finished(scene).empty());
    Material alone;
    set_words({.base = decoded(dvec3(1, 0.9, 0.5)), .metallic = 1, .roughness = 0.4}, alone);
    EXPECT_NEAR(scene.materials[0].Ns, alone.Ns, 0.3 * alone.Ns);
    const vec3 Ks = at(scene.materials[0].Ks, scene.materials[0].map_Ks, 0);
    EXPECT_NEAR(Ks.x, alone.Ks.x, 0.05);
    EXPECT_NEAR(Ks.z, alone.Ks.z, 0.05);
    EXPECT_GT(at(scene.materials[0].Ks, scene.materials[0].map_Ks, 1).x, 0.2);
}

TEST(MetalMap, BothModelsOfOneSurfaceAreDrawnAlike) {
    Scene metal = surface(dvec3(1), 1, {{0, 0.4, 1}, {0, 0.8, 0}});
    metal.materials[0].map_Kd = {map_of({{1, 0.9, 0.5}, {0, 0, 0}})};
    Scene gloss = surface(dvec3(0), 0, {{0, 0, 0}});
    const auto u16 = [](double v) { return std::uint16_t(std::lround(v * 65535)); };
    const std::uint16_t dark = u16(srgb(0.04));
    gloss.materials[0].map_metal[0].texture =
        make_texture("texels", 2, 1,
                     std::vector<std::uint16_t>{0xFFFF, u16(0.9), u16(0.5), u16(0.6), dark, dark,
                                                dark, u16(0.2)});
    gloss.materials[0].physical = std::make_shared<const Physical>(
        Physical{.base = dvec3(0), .F0 = dvec3(1), .metallic = 0, .roughness = 0});
    EXPECT_TRUE(finished(metal).empty());
    EXPECT_TRUE(finished(gloss).empty());
    const Material &a = metal.materials[0], &b = gloss.materials[0];
    EXPECT_NEAR(a.Ns, b.Ns, 0.02 * a.Ns);
    for (const std::size_t i : {0u, 1u})
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(at(a.Ka, a.map_Ka, i)[k], at(b.Ka, b.map_Ka, i)[k], 0.01);
            EXPECT_NEAR(at(a.Kd, a.map_Kd, i)[k], at(b.Kd, b.map_Kd, i)[k], 0.01);
            EXPECT_NEAR(at(a.Ks, a.map_Ks, i)[k], at(b.Ks, b.map_Ks, i)[k], 0.01);
        }
}

TEST(MetalMap, AnEvenMapIsTheMaterialByFactor) {
    Scene scene = surface({0.5, 0.25, 0.1}, 1, {{0, 0.5, 1}, {0, 0.5, 1}});
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    const double r = 0.5;  // 0.5 / (4 r^4) is beyond white
    EXPECT_NEAR_3(m.Kd, metal_Kd(srgb(1), r), metal_Kd(srgb(0.5), r), metal_Kd(srgb(0.2), r));
    EXPECT_TRUE(m.map_Kd.empty());
    EXPECT_TRUE(m.map_Ks.empty());
    EXPECT_NEAR_3(m.Ks, metal_Ks(srgb(1), r), metal_Ks(srgb(0.5), r), metal_Ks(srgb(0.2), r));
}

TEST(MetalMap, AMapThatLiesInAnotherWayHasItsMeans) {
    Scene scene = surface(dvec3(0.5), 1, {{0, 0.5, 0}, {0, 0.5, 0.5}});
    scene.materials[0].map_Kd = {map_of({{1, 1, 1}})};
    scene.materials[0].map_Kd[0].scale = vec2(2);
    EXPECT_EQ(finished(scene),
              (std::vector<std::string>{
                  "m.gltf: material 'helmet': its metallicRoughnessTexture lies in another way "
                  "than its colours; expected the same, so it is drawn with its means"}));
    // A quarter of metal, roughness 0.5.
    const double diffuse = 0.5 * 0.75, peak = (0.04 * 0.75 + 0.5 * 0.25) * 4;
    EXPECT_NEAR(at(scene.materials[0].Kd, scene.materials[0].map_Kd, 0).x,
                srgb(diffuse) + metal_Kd(srgb(diffuse + peak) - srgb(diffuse), 0.5) / 4, 1e-4);
}

namespace {

/// F0 and glossiness by two texels, of this diffuse colour.
Scene glossy(const dvec3& diffuse, const dvec3& F0) {
    Scene scene;
    Material m{.name = "old"};
    const std::vector<std::uint16_t> texels{0xFFFF, 0xFFFF, 0xFFFF, 0x7FFF, 0, 0, 0, 0xFFFF};
    m.map_metal = {Map{.origin = {"m.gltf", 0}, .texture = make_texture("texels", 2, 1, texels)}};
    m.physical = std::make_shared<const Physical>(
        Physical{.base = diffuse, .F0 = F0, .metallic = 0, .roughness = 0.2});
    scene.materials = {m};
    return scene;
}

/// Half of the glossiness 0.8: the other texel reflects nothing.
constexpr double glossy_roughness = 1 - 0.8 * 0.5;

}  // namespace

/// Each texel is the surface by factors, with the glossiness of what reflects.
TEST(SpecularGlossinessMap, IsTheSurfaceOfEachTexel) {
    Scene scene = glossy({0.5, 0.25, 0}, {1, 0.75, 0.25});
    scene.materials[0].map_Kd = {map_of({{0.4, 1, 0}, {0.4, 1, 0}})};
    EXPECT_TRUE(finished(scene).empty());
    const Material& m = scene.materials[0];
    const dvec3 diffuse = dvec3(0.5, 0.25, 0) * decoded(dvec3(0.4, 1, 0));
    for (const std::size_t i : {0u, 1u}) {
        const dvec3 F0 = i == 0 ? dvec3(1, 0.75, 0.25) : dvec3(0);
        Material expected;
        set_words({.base = diffuse, .F0 = F0, .roughness = glossy_roughness}, expected);
        EXPECT_NEAR_3(at(m.Ka, m.map_Ka, i), expected.Ka.x, expected.Ka.y, expected.Ka.z);
        EXPECT_NEAR_3(at(m.Kd, m.map_Kd, i), expected.Kd.x, expected.Kd.y, expected.Kd.z);
        EXPECT_NEAR_3(at(m.Ks, m.map_Ks, i), expected.Ks.x, expected.Ks.y, expected.Ks.z);
    }
    EXPECT_GT(m.Ns, 1);
    EXPECT_TRUE(m.map_metal.empty());
}

/// Gold is black but for F0, by a texture or by factors.
TEST(SpecularGlossinessMap, GoldReflectsLightFromAllSides) {
    Scene scene = glossy(dvec3(0), {1, 0.75, 0.25});
    EXPECT_TRUE(finished(scene).empty());
    EXPECT_NEAR_3(at(scene.materials[0].Ka, scene.materials[0].map_Ka, 0), 1, srgb(0.75),
                  srgb(0.25));
    Scene black = glossy(dvec3(0), {1, 0.75, 0.25});
    black.materials[0].map_metal.clear();
    black.materials[0].map_Kd = {map_of({{0, 0, 0}})};
    EXPECT_TRUE(finished(black).empty());
    EXPECT_NEAR_3(at(black.materials[0].Ka, black.materials[0].map_Ka, 0), 1, srgb(0.75),
                  srgb(0.25));
}

TEST(SpecularGlossinessMap, ThatLiesInAnotherWayHasItsMeans) {
    Scene scene = glossy(dvec3(0), dvec3(0.5));
    scene.materials[0].map_Kd = {map_of({{1, 1, 1}})};
    scene.materials[0].map_Kd[0].scale = vec2(2);
    EXPECT_EQ(finished(scene),
              (std::vector<std::string>{
                  "m.gltf: material 'old': its specularGlossinessTexture lies in another way "
                  "than its colours; expected the same, so it is drawn with its means"}));
    const Material& m = scene.materials[0];
    EXPECT_NEAR_3(at(m.Ka, m.map_Ka, 0), srgb(0.25), srgb(0.25), srgb(0.25));
}

TEST(MetalMap, OfAnotherSetOfCoordinatesIsItsMeans) {
    Scene scene = surface({0.5, 0.25, 0.1}, 1, {{0, 1, 0}, {0, 0.5, 1}});
    const double r = (0.04 * 1 + 0.5 * 0.5) / (0.04 + 0.5);
    Scene even = surface({0.5, 0.25, 0.1}, 1, {{0, r, 0.5}});
    scene.materials[0].map_metal[0].is_mean = true;
    EXPECT_TRUE(finished(scene).empty());
    EXPECT_TRUE(finished(even).empty());
    EXPECT_TRUE(scene.materials[0].map_Kd.empty());
    EXPECT_NEAR(scene.materials[0].Ks.x, even.materials[0].Ks.x, 1e-4);
    EXPECT_NEAR(scene.materials[0].Kd.x, even.materials[0].Kd.x, 1e-4);
}

}  // namespace gw::scene
