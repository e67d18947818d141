// Claims: each section and key of a TOML scene lands in the scene as docs/scenes.md says.
#include <gtest/gtest.h>

#include "folder.h"

namespace gw::scene {

namespace {

struct Toml : testing::Test {
    Folder folder;
    Toml() {
        folder.write("t.obj",
                     "mtllib t.mtl\n" + triangle +
                         "g a\nusemtl red\nf 1 2 3\ng b\nusemtl blue\nf 1 2 3\nf 3 2 1\ng c\nf 1 2 3\n");
        folder.write("t.mtl",
                     "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nNs 5\nnewmtl unused\nmap_Kd no.png\n");
    }
    SceneFile file(const std::string& text) { return read_scene(folder.write("s.toml", text)); }
    Scene scene(const std::string& text) { return file(text + "\n[[object]]\nfile = 't.obj'\n").scene; }
    Scene object(const std::string& keys) { return file("[[object]]\nfile = 't.obj'\n" + keys).scene; }
};

using Ids = std::vector<std::uint32_t>;

}  // namespace

TEST_F(Toml, ObjectsBringPartsAndTheMaterialsTheyUse) {
    const Scene s = object("");
    EXPECT_EQ(s.name, "s");
    ASSERT_EQ(s.objects.size(), 3u);
    EXPECT_EQ(s.objects[0].name, "a");
    EXPECT_EQ(s.objects[2].name, "c");
    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.materials[0].name, "red");
    EXPECT_EQ(s.objects[1].material, 1u);
    EXPECT_EQ(s.objects[2].material, 1u);
    EXPECT_FALSE(s.camera || s.fog);
    EXPECT_TRUE(s.lights.empty());
}

TEST_F(Toml, PolygonIdsRunThroughTheScene) {
    const Scene s = object("[[object]]\nfile = 't.obj'\nparts = 'b'\n");
    ASSERT_EQ(s.objects.size(), 4u);
    EXPECT_EQ(s.objects[0].mesh->data().polygon_ids, (Ids{0}));
    EXPECT_EQ(s.objects[1].mesh->data().polygon_ids, (Ids{1, 2}));
    EXPECT_EQ(s.objects[2].mesh->data().polygon_ids, (Ids{3}));
    EXPECT_EQ(s.objects[3].mesh->data().polygon_ids, (Ids{4, 5}));
}

}  // namespace gw::scene
