// OBJ files as scenes of their own: what stands in for what they lack.
#include "tests/scene/folder.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

using Strings = std::vector<std::string>;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const vec3 default_Kd = Material{}.Kd;

class BareObj : public testing::Test {
protected:
    SceneFile scene(const std::string& text, const std::string& name = "m.obj") {
        return read_scene(folder.write(name, text));
    }
    Strings warnings(const SceneFile& file) const {
        Strings lines;
        for (const std::string& line : file.warnings) lines.push_back(folder.relative(line));
        return lines;
    }

    Folder folder;
};

TEST_F(BareObj, WithoutMaterialsTheDefaultOneStandsIn) {
    const SceneFile none =
        scene(triangle + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\n");
    EXPECT_EQ(warnings(none),
              Strings{"m.obj:4: unknown material 'red'; none is known; the default one stands in"});
    ASSERT_EQ(none.scene.objects.size(), 2u);
    for (const Material& material : none.scene.materials) EXPECT_EQ(material.Kd, default_Kd);
}

TEST_F(BareObj, WithoutItsLibraryTheDefaultMaterialStandsIn) {
    const SceneFile lost =
        scene("mtllib no such.mtl\n" + triangle + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\n");
    EXPECT_EQ(warnings(lost),
              (Strings{"m.obj:1: mtllib 'no such.mtl' does not exist; expected an MTL file",
                       "m.obj:5: unknown material 'red'; none is known (line 1: mtllib "
                       "'no such.mtl' does not exist); the default one stands in"}));
    EXPECT_EQ(lost.scene.objects.size(), 2u);
}

TEST_F(BareObj, NamesThatTheLibraryLacksAreWarnedOfOneByOne) {
    folder.write("m.mtl", "newmtl blue\nKd 0 0 1\nnewmtl red\nKd 1 0 0\n");
    const SceneFile some = scene("mtllib m.mtl\n" + triangle +
                                 "usemtl rde\nf 1 2 3\nusemtl blu\nf 1 2 3\nusemtl red\nf 1 2 3\n");
    EXPECT_EQ(
        warnings(some),
        (Strings{"m.obj:5: unknown material 'rde'; the nearest known is 'red'; the default one "
                 "stands in",
                 "m.obj:7: unknown material 'blu'; the nearest known is 'blue'; the default one "
                 "stands in"}));
    ASSERT_EQ(some.scene.objects.size(), 3u);
    const auto kd = [&](std::size_t i) {
        return some.scene.materials[some.scene.objects[i].material].Kd;
    };
    EXPECT_EQ(kd(0), default_Kd);
    EXPECT_EQ(kd(1), default_Kd);
    EXPECT_EQ(kd(2), vec3(1, 0, 0));
}

TEST_F(BareObj, InAScenesFileItsFacesHaveTheDefaultMaterialToo) {
    folder.write("u.obj", triangle + "usemtl gren\nf 1 2 3\n");
    const SceneFile file = scene("[[object]]\nfile = 'u.obj'\n[material.green]\n", "s.toml");
    EXPECT_EQ(warnings(file), Strings{"u.obj:4: unknown material 'gren'; the nearest known is "
                                      "'green'; the default one stands in"});
}

TEST_F(BareObj, IsLitThoughAPartOfItGlows) {
    const std::string model = "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\n";
    folder.write("m.mtl", "newmtl a\nKd 1 0 0\n");
    EXPECT_EQ(scene(model).scene.lights.size(), 0u);  // drawing adds the light
    folder.write("m.mtl", "newmtl a\nKd 1 0 0\nKe 0.1 0.1 0.1\n");
    const SceneFile glowing = scene(model);
    ASSERT_EQ(glowing.scene.lights.size(), 1u);
    EXPECT_LT(glowing.scene.lights[0].direction.z, 0);  // from the eye, which is in front
    // A scene of TOML says itself what its lights are.
    EXPECT_EQ(scene("[[object]]\nfile = 'm.obj'\n", "s.toml").scene.lights.size(), 0u);
}

TEST_F(BareObj, AdditionsOfOtherProgramsAreLeftOut) {
    EXPECT_EQ(
        warnings(scene(triangle + "f 1 2 3\nt crease 2/1/0 1 2 4.7\nt crease 2/1/0 2 3 1\n"
                                  "vw 1 0 0.5 1 0.5\n")),
        (Strings{"m.obj:5: t statements are not drawn", "m.obj:7: vw statements are not drawn"}));
}

TEST_F(BareObj, ColoursOfVerticesAreWarnedOf) {
    const std::string rest = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const Strings warning{"m.obj:1: colours of v are not drawn; expected them in a map (map_Kd)"};
    EXPECT_EQ(warnings(scene("v 0 0 0 1 0.5 0\n" + rest)), warning);
    EXPECT_EQ(warnings(scene("v 0 0 0 1 0.5 0 1\n" + rest)), warning);
    EXPECT_EQ(warnings(scene("v 0 0 0 1 1 1\n" + rest)), Strings());
    EXPECT_EQ(warnings(scene("v 0 0 0 1\n" + rest)), Strings());
}

TEST_F(BareObj, ColoursThatAreNotFiniteDoNotMatter) {
    const SceneFile file =
        scene("v 2 3 4 nan nan nan\nv 1 0 0 -nan(ind) inf 0 1\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(warnings(file),
              Strings{"m.obj:1: colours of v are not drawn; expected them in a map (map_Kd)"});
    EXPECT_EQ(file.scene.objects[0].mesh->data().positions[0], vec3(2, 3, 4));
    EXPECT_EQ(
        folder.scene_error("p.obj", "v 0 nan 0 1 1 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        "p.obj:1: 'nan' is not finite; expected v x y z, v x y z w, v x y z r g b or v x y z r "
        "g b a");
}

}  // namespace
}  // namespace gw::scene
