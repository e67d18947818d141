// Claims: a model whose pictures are missing is drawn without them, and each file that names some says
// so once. A scene's own map is kept.
#include "scene/maps/finish.h"
#include "scene/maps/physical.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

Map named(const std::string& picture, const std::string& file, int line, bool may_lack = true) {
    return {.file = picture, .origin = {file, line}, .may_lack = may_lack};
}

std::vector<std::string> finished(Scene& scene) {
    Warnings warnings;
    finish(scene, warnings);
    return warnings.lines();
}

}  // namespace

TEST(MissingPictures, AreLeftOutWithOneWarningOfEachFile) {
    Scene scene;
    Material wood{.name = "wood"}, leaf{.name = "leaf"}, plain{.name = "plain"};
    wood.map_Kd = {named("wood.png", "a.mtl", 3)};
    wood.map_Ks = {named("wood.png", "a.mtl", 4)};
    leaf.map_Kd = {named("leaf.png", "b.mtl", 7)};
    leaf.map_d = {named("hole.png", "b.mtl", 8)};
    plain.refl = {named("sky.png", "b.mtl", 12)};
    scene.materials = {wood, leaf, plain};
    EXPECT_EQ(finished(scene), (std::vector<std::string>{
                                   "a.mtl:3: map_Kd wood.png: no such file; expected a picture "
                                   "file, so it is left out",
                                   "b.mtl:7: map_Kd leaf.png: no such file; expected a picture "
                                   "file, so it is left out, beside 2 more"}));
    for (const Material& m : scene.materials)
        EXPECT_TRUE(m.map_Kd.empty() && m.map_Ks.empty() && m.map_d.empty() && m.refl.empty());
}

TEST(MissingPictures, OfASceneItselfAreKept) {
    Scene scene;
    Material wood{.name = "wood"};
    wood.map_Kd = {named("wood.png", "s.toml", 3, false)};
    scene.materials = {wood};
    EXPECT_TRUE(finished(scene).empty());
    EXPECT_EQ(scene.materials[0].map_Kd.size(), 1u);
}

/// What is left of a metal without its maps is the metal by factors.
TEST(MissingPictures, OfAMetalLeaveItsFactors) {
    Scene scene;
    Material metal{.name = "metal", .Ks = vec3(0.5f)};
    metal.map_metal = {named("metal.png", "m.gltf", 0)};
    metal.physical = std::make_shared<const Physical>();
    scene.materials = {metal};
    EXPECT_EQ(finished(scene).size(), 1u);
    EXPECT_EQ(scene.materials[0].Ks, vec3(0.5f));
}

}  // namespace gw::scene
