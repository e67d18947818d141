// Claims: a finished scene has one opacity for each object, also in films; a map of opacity is the
// channel that its statement chooses; maps of what was cut have no alpha; mirrored maps repeat a
// texture that holds the mirror image.
#include "scene/maps/finish.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gw::scene {
namespace {

TextureRef texture(int width, int height, const std::vector<double>& alpha) {
    std::vector<std::uint16_t> rgba;
    for (const double a : alpha)
        rgba.insert(rgba.end(), {1000, 2000, 3000, std::uint16_t(std::lround(a * 65535))});
    return make_texture("leaf", width, height, rgba);
}

/// A square with this texture.
Scene leaf(const TextureRef& texture) {
    Scene scene;
    Material m{.name = "leaf"};
    m.map_Kd = m.map_d = {Map{.origin = {"leaf.gltf", 0},
                              .wrap_s = Wrap::Clamp,
                              .wrap_t = Wrap::Clamp,
                              .texture = texture}};
    scene.materials = {m};
    scene.objects = {{.name = "square",
                      .mesh = make_mesh({.primitive = Primitive::Quads,
                                         .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                         .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}})}};
    return scene;
}

std::vector<float> opacities(const Scene& scene) {
    std::vector<float> list;
    for (const Object& object : scene.objects) list.push_back(scene.materials[object.material].d);
    return list;
}

std::vector<std::string> finished(Scene& scene) {
    Warnings warnings;
    finish(scene, warnings);
    return warnings.lines();
}

}  // namespace

TEST(Finish, ATextureOfOneAlphaIsExact) {
    Scene scene = leaf(texture(2, 1, {0.3, 0.3}));
    scene.materials[0].d = 0.5f;
    const MeshRef mesh = scene.objects[0].mesh;
    finished(scene);
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].mesh, mesh);
    EXPECT_NEAR(opacities(scene)[0], 0.15, 1e-5);
}

/// The opacity of the square under a texture of this one texel.
float opacity_of(const std::array<double, 4>& rgba, OpacityChannel channel) {
    std::vector<std::uint16_t> texels;
    for (const double v : rgba) texels.push_back(std::uint16_t(std::lround(v * 65535)));
    Scene scene = leaf(make_texture("texel", 1, 1, texels));
    scene.materials[0].map_d[0].channel = channel;
    finished(scene);
    return opacities(scene).at(0);
}

TEST(Finish, AMapOfOpacityIsTheChannelThatItsStatementChooses) {
    const std::array<double, 4> texel{0.1, 0.4, 0.7, 0.6};
    const double near = 1e-5;
    EXPECT_NEAR(opacity_of(texel, OpacityChannel::Red), 0.1, near);
    EXPECT_NEAR(opacity_of(texel, OpacityChannel::Green), 0.4, near);
    EXPECT_NEAR(opacity_of(texel, OpacityChannel::Blue), 0.7, near);
    EXPECT_NEAR(opacity_of(texel, OpacityChannel::Alpha), 0.6, near);
    const double luminance = 0.2126 * 0.1 + 0.7152 * 0.4 + 0.0722 * 0.7;
    EXPECT_NEAR(opacity_of(texel, OpacityChannel::Luminance), luminance, near);
    EXPECT_NEAR(opacity_of(texel, OpacityChannel::AlphaOrLuminance), 0.6, near);
    EXPECT_NEAR(opacity_of({0.1, 0.4, 0.7, 1}, OpacityChannel::AlphaOrLuminance), luminance, near);
    EXPECT_EQ(opacity_of({1, 1, 1, 1}, OpacityChannel::AlphaOrLuminance), 1);
}

TEST(Finish, AMapOfOpacityLeavesTheTextureOfColours) {
    Scene scene = leaf(texture(4, 1, {1, 1, 1, 1}));
    const TextureRef colors = scene.materials[0].map_Kd[0].texture;
    scene.materials[0].map_d[0].channel = OpacityChannel::Blue;
    finished(scene);
    const Material& drawn = scene.materials[scene.objects[0].material];
    EXPECT_NEAR(drawn.d, 3000 / 65535.0, 1e-6);
    EXPECT_EQ(drawn.map_Kd.at(0).texture, colors);
}

TEST(Finish, AMapOfOpacityWithoutTextureCoordinatesIsOneWarning) {
    Scene scene = leaf(texture(4, 1, {1, 1, 0, 0}));
    MeshData bare = scene.objects[0].mesh->data();
    bare.texcoords.clear();
    scene.objects[0].mesh = make_mesh(std::move(bare));
    scene.objects.push_back(scene.objects[0]);
    EXPECT_EQ(finished(scene), (std::vector<std::string>{
                                   "leaf.gltf: object 'square' has no texture coordinates; "
                                   "expected some for its map of opacity, which is not used"}));
    EXPECT_EQ(opacities(scene), (std::vector<float>{1, 1}));
}

TEST(Finish, ABlendedTextureIsCutIntoLevels) {
    Scene scene = leaf(texture(4, 1, {1, 1, 0.5, 0.5}));
    finished(scene);
    const std::vector<float> d = opacities(scene);
    ASSERT_EQ(d.size(), 9u);  // 8/16 .. 16/16
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(d[i], float(8 + i) / 16);
    for (const Object& object : scene.objects) EXPECT_EQ(object.name, "square");
}

TEST(Finish, AMaskLeavesOpaqueObjects) {
    Scene scene = leaf(texture(4, 1, {1, 1, 0, 0}));
    scene.materials[0].d_cutoff = 0.5f;
    finished(scene);
    EXPECT_EQ(opacities(scene), std::vector<float>{1});
}

TEST(Finish, WhatIsAllBelowTheCutoffIsInvisible) {
    Scene scene = leaf(texture(4, 1, {0.2, 0.1, 0, 0}));
    scene.materials[0].d_cutoff = 0.5f;
    finished(scene);
    EXPECT_EQ(opacities(scene), std::vector<float>{0});
}

TEST(Finish, MapsOfCutMaterialsAreOpaque) {
    Scene scene = leaf(texture(4, 1, {1, 1, 0.5, 0.5}));
    finished(scene);
    for (const Object& object : scene.objects) {
        const TextureLevel& level =
            scene.materials[object.material].map_Kd.at(0).texture->levels.front();
        for (std::size_t i = 0; i < level.rgba.size(); i += 4) {
            EXPECT_EQ(level.rgba[i], 1000);
            EXPECT_EQ(level.rgba[i + 3], 0xFFFF);
        }
    }
}

TEST(Finish, AFilmIsCutAtEachTime) {
    Scene scene = leaf(texture(4, 1, {1, 1, 0, 0}));
    scene.materials[0].d_cutoff = 0.5f;
    scene.objects.push_back(scene.objects[0]);
    std::vector<Film> films(1);
    films[0].pose = [](Scene& s, double time) {
        ASSERT_EQ(s.objects.size(), 2u);
        s.objects[1].world_from_object[3].x = time;
        s.materials[0].d_cutoff = float(time);
    };
    Warnings warnings;
    finish(scene, films, warnings);
    for (const double time : {2.0, 0.5, 0.75}) {
        films[0].pose(scene, time);
        EXPECT_EQ(scene.objects.size(), 2u);
        EXPECT_EQ(scene.objects[1].world_from_object[3].x, time);
        EXPECT_EQ(scene.materials[scene.objects[0].material].d, time > 1 ? 0.0f : 1.0f);
    }
}

TEST(Finish, TooFineAnOpacityIsOneWarning) {
    std::vector<double> alpha(2048 * 2048);
    for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = double(i * 7919 % 101) / 100;
    Scene scene = leaf(texture(2048, 2048, alpha));
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].name = "other";
    EXPECT_EQ(
        finished(scene),
        (std::vector<std::string>{
            "leaf.gltf: object 'square': its opacity would cut the scene into more than 1048576 "
            "triangles or 1000000 objects; expected fewer, so it is drawn with one opacity"}));
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_NEAR(opacities(scene)[0], 0.5, 0.01);
}

TEST(Finish, TooFineAMaskIsCutAtOneHalf) {
    constexpr int side = 512, period = 8;  // a hole of 2x2 texels in each 8x8
    std::vector<double> alpha(side * side, 1);
    const auto is_in_hole = [](int i) { return i % period == 2 || i % period == 3; };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (is_in_hole(x) && is_in_hole(y)) alpha[std::size_t(y * side + x)] = 0;
    Scene scene = leaf(texture(side, side, alpha));
    EXPECT_EQ(
        finished(scene),
        (std::vector<std::string>{
            "leaf.gltf: object 'square': its opacity would cut the scene into more than 1048576 "
            "triangles or 1000000 objects; expected fewer, so it is cut at 0.5"}));
    ASSERT_EQ(opacities(scene), std::vector<float>{1});
    double area = 0;
    const std::vector<vec3>& at = scene.objects[0].mesh->data().positions;
    for (std::size_t i = 0; i + 2 < at.size(); i += 3)
        area += glm::length(glm::cross(dvec3(at[i + 1] - at[i]), dvec3(at[i + 2] - at[i]))) / 2;
    // Between the middles of texels: all of the square in a hole, half of the four at its sides, a
    // sixth of the four at its corners.
    const double hole = 1 + 4 * (1.0 / 2) + 4 * (1.0 / 6);
    EXPECT_NEAR(1 - area, hole / (period * period), 1e-5);
}

TEST(Finish, MirroredMapsHoldTheirMirrorImage) {
    Scene scene = leaf(texture(2, 2, {0.1, 0.2, 0.3, 0.4}));
    scene.materials[0].map_d.clear();
    Map& map = scene.materials[0].map_Kd[0];
    map.wrap_s = Wrap::MirroredRepeat;
    map.scale = vec2(3, 5);
    map.offset = vec2(1, 7);
    EXPECT_TRUE(finished(scene).empty());
    EXPECT_EQ(map.wrap_s, Wrap::Repeat);
    EXPECT_EQ(map.wrap_t, Wrap::Clamp);
    EXPECT_EQ(map.scale, vec2(1.5f, 5));
    EXPECT_EQ(map.offset, vec2(0.5f, 7));
    ASSERT_EQ(map.texture->width(), 4);
    ASSERT_EQ(map.texture->height(), 2);
    const double expected[] = {0.1, 0.2, 0.2, 0.1, 0.3, 0.4, 0.4, 0.3};
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(map.texture->levels.front().rgba[4 * i + 3], std::lround(expected[i] * 65535));
}

TEST(Finish, AMirroredMapThatIsTooLargeIsOneWarning) {
    Scene scene = leaf(texture(4096, 1, std::vector<double>(4096, 1)));
    scene.materials[0].map_Kd[0].wrap_s = Wrap::MirroredRepeat;
    EXPECT_EQ(finished(scene),
              (std::vector<std::string>{"leaf.gltf: a map of 4096 texels repeats without being "
                                        "mirrored; expected at most 2048"}));
}

/// Half of the light of white is 188 of 255 in sRGB, 128 if light is counted.
TEST(Finish, PutsAMeanInPlaceOfAMapWithoutCoordinates) {
    for (const bool is_encoded : {true, false}) {
        Scene scene;
        Material m{.name = "lamp"};
        m.is_encoded = is_encoded;
        const std::vector<std::uint8_t> texels{255, 255, 255, 255, 0, 0, 0, 255};
        m.map_Ke = {Map{.texture = make_texture8("dots", 2, 1, texels), .is_mean = true}};
        scene.materials = {m};
        Warnings warnings;
        finish(scene, warnings);
        const Texture& mean = *scene.materials[0].map_Ke.at(0).texture;
        EXPECT_EQ(mean.width() * mean.height(), 1);
        EXPECT_EQ((mean.levels.front().rgba[0] + 128) / 257, is_encoded ? 188 : 128);
    }
}

}  // namespace gw::scene
