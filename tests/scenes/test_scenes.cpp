// Claims: every scene of scenes/ can be read with its maps, and is as docs/gallery.md describes it.
#include "image/textures.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace gw::scene {
namespace {

const std::filesystem::path folder = std::filesystem::path(GW_SOURCE_DIR) / "scenes";

std::vector<std::string> files() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

class Scenes : public testing::TestWithParam<std::string> {};

TEST_P(Scenes, IsReadWithItsMapsAndWithoutAWarning) {
    SceneFile file = read_scene(folder / GetParam());
    EXPECT_EQ(file.warnings, std::vector<std::string>());
    EXPECT_FALSE(file.scene.objects.empty());
    EXPECT_FALSE(file.scene.lights.empty());
    EXPECT_TRUE(file.scene.camera.has_value());
    EXPECT_EQ(file.scene.name + ".toml", GetParam());
    EXPECT_NO_THROW(image::load_textures(file.scene));
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(files()), [](const auto& test) {
    return test.param.substr(0, test.param.find('.'));
});

TEST(Rings, DifferOnlyInTheMap) {
    Scene with = read_scene(folder / "rings.toml").scene,
          without = read_scene(folder / "rings_plain.toml").scene;
    ASSERT_EQ(with.materials.size(), 1u);
    ASSERT_EQ(without.materials.size(), 1u);
    EXPECT_EQ(with.materials[0].map_Kd.size(), 1u);
    EXPECT_EQ(without.materials[0].map_Kd.size(), 0u);
    EXPECT_EQ(with.materials[0].Ks, without.materials[0].Ks);
    EXPECT_EQ(with.materials[0].Kd, without.materials[0].Kd);
    ASSERT_EQ(with.objects.size(), without.objects.size());
    for (std::size_t i = 0; i < with.objects.size(); ++i) {
        EXPECT_EQ(with.objects[i].mesh->data(), without.objects[i].mesh->data());
        EXPECT_EQ(with.objects[i].world_from_object, without.objects[i].world_from_object);
    }
}

TEST(Marble, HasAMapForEachComponent) {
    const Scene scene = read_scene(folder / "marble.toml").scene;
    const auto marble = std::ranges::find(scene.materials, "marble", &Material::name);
    ASSERT_NE(marble, scene.materials.end());
    EXPECT_EQ(marble->map_Ka.size(), 1u);
    EXPECT_EQ(marble->map_Kd.size(), 1u);
    EXPECT_EQ(marble->map_Ks.size(), 1u);
    EXPECT_EQ(marble->refl.size(), 1u);
    EXPECT_NE(marble->map_Kd[0].file, marble->map_Ks[0].file);
}

}  // namespace
}  // namespace gw::scene
