// Claims: deep keys and too many triangles are refused before they are built; a scene of very many
// objects is read piece by piece as if it was read whole.
#include <gtest/gtest.h>

#include "scene/draw/draw_commands.h"
#include "scene/toml/read_profile.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
}

/// Objects of two kinds on five lines each. The header may be written in another form.
std::string many_objects(int count, const std::string& header) {
    std::string text = "# a comment\n";
    for (int i = 0; i < count; ++i) {
        text += header + "\nname = \"b" + std::to_string(i) + "\"\n";
        text += i % 2 == 0 ? "shape = 'box'\n" : "shape = 'rectangle'\n";
        text += "translate = [" + std::to_string(i) + ".5, 0, 0]\n";
        text += i % 3 == 0 ? "[object.material]\nKd = [1, 0, 0]\n" : "\n";
        if (i == count / 2) text += "[camera]\neye = [0, 0, 9]\n[[light]]\nposition = [0, 1, 0]\n";
    }
    return text;
}

constexpr const char* too_deep =
    "s.toml:1: too many levels of keys and brackets; expected fewer than 64";

}  // namespace

TEST(DeepToml, IsRefused) {
    const Folder folder;
    for (const std::string& text : std::vector<std::string>{
             repeated("a.", 20000) + "a = 1\n", "[" + repeated("a.", 20000) + "a]\n",
             "[[" + repeated("'a' . ", 20000) + "a]]\n", "a = " + repeated("[", 20000),
             "a = " + repeated("{a = ", 20000), "a = " + repeated("[{a.a.a.a = ", 30)})
        EXPECT_EQ(folder.scene_error("s.toml", text), too_deep) << text.substr(0, 20);
    const auto profile = folder.write("s.toml", repeated("a.", 20000) + "a = 1\n");
    EXPECT_EQ(folder.error([&] { read_profile(profile); }), too_deep);
}

TEST(DeepToml, CountsTheLevelsOfAKeyInItsTable) {
    const Folder folder;
    const std::string header = "[" + repeated("a.", 39) + "b]\n";
    EXPECT_EQ(folder.scene_error("s.toml", header + repeated("a.", 40) + "b = 1\n"),
              "s.toml:2: too many levels of keys and brackets; expected fewer than 64");
    EXPECT_EQ(folder.scene_error("s.toml", header + repeated("a.", 9) + "b = [1.5, 2.5]\n"),
              "s.toml:1: unknown key 'a'; the nearest known is 'name'");
    EXPECT_EQ(folder.scene_error("s.toml", "a = [" + repeated("{b = [1.5]}, ", 100) + "]\n"),
              "s.toml:1: unknown key 'a'; the nearest known is 'name'");
}

TEST(LargeScene, SaysHowManyTrianglesItWouldHave) {
    const Folder folder;
    EXPECT_EQ(
        folder.scene_error("s.toml",
                           "\n[[object]]\nshape = 'rectangle'\ncolumns = 256\nrows = 256\n"
                           "divide = 256\n"),
        "s.toml:2: object has 8589934592 triangles, this and all before it 8589934592; expected "
        "at most 33554432 in shapes and divided files");
    folder.write("q.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + repeated("f 1 2 3 4\n", 300));
    EXPECT_EQ(
        folder.scene_error("s.toml", "[[object]]\nfile = 'q.obj'\ndivide = 256\n"),
        "s.toml:1: object has 39321600 triangles, this and all before it 39321600; expected at "
        "most 33554432 in shapes and divided files");
    EXPECT_EQ(folder.scene_error("s.toml", repeated("[[object]]\nshape = 'box'\nsegments = 1024\n"
                                                    "visible = false\n",
                                                    9)),
              "s.toml:1: has nothing to draw; expected an [[object]] that is visible");
}

TEST(LargeScene, ReadInPiecesIsTheSame) {
    const Folder folder;
    const auto pieces = folder.write("a.toml", many_objects(3000, "[[object]]"));
    const auto whole = folder.write("b.toml", many_objects(3000, "[[ object ]]"));
    const Scene a = read_scene(pieces).scene, b = read_scene(whole).scene;
    ASSERT_EQ(a.objects.size(), 3000u);
    ASSERT_EQ(b.objects.size(), 3000u);
    EXPECT_EQ(a.lights.size(), 1u);
    EXPECT_EQ(a.camera->eye, dvec3(0, 0, 9));
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        const Object &p = a.objects[i], &q = b.objects[i];
        ASSERT_EQ(p.name, "b" + std::to_string(i));
        ASSERT_EQ(p.name, q.name);
        ASSERT_EQ(p.world_from_object, q.world_from_object);
        ASSERT_EQ(p.world_from_object[3].x, double(i) + 0.5);
        ASSERT_EQ(p.mesh->data().positions, q.mesh->data().positions);
        ASSERT_EQ(p.material, q.material);
        ASSERT_EQ(a.materials[p.material].Kd, i % 3 == 0 ? vec3(1, 0, 0) : vec3(0.8f));
    }
}

TEST(LargeScene, NamesTheLineInEveryPiece) {
    const Folder folder;
    const std::string before = many_objects(3000, "[[object]]");
    const auto lines = std::ranges::count(before, '\n');
    EXPECT_EQ(folder.scene_error("s.toml", before + "[[object]]\nshape = 'bxo'\n"),
              "s.toml:" + std::to_string(lines + 2) +
                  ": unknown shape 'bxo'; the nearest known is 'box'");
    EXPECT_EQ(folder.scene_error("s.toml", before + "[[object]]\nshape = \n").substr(0, 13),
              "s.toml:" + std::to_string(lines + 2) + ":");
    EXPECT_EQ(folder.scene_error("s.toml", before + "[object]\n")
                  .substr(0, 8 + std::to_string(lines).size()),
              "s.toml:" + std::to_string(lines + 1) + ":");
}

TEST(LargeScene, ObjectsOfOneShapeShareAMeshButNoIdentifier) {
    const Folder folder;
    const Scene s = read_scene(folder.write("s.toml", many_objects(3000, "[[object]]"))).scene;
    EXPECT_NE(s.objects[0].mesh, s.objects[2].mesh);
    EXPECT_EQ(s.objects[1200].mesh, s.objects[2998].mesh);
    EXPECT_NE(s.objects[1200].mesh, s.objects[1201].mesh);
    const PolygonIds ids = polygon_ids(s);
    EXPECT_EQ(ids.end, 1 + 1500 * (6 + 1));
    for (std::size_t i = 1; i < ids.first.size(); ++i)
        ASSERT_EQ(ids.first[i] - ids.first[i - 1], i % 2 == 1 ? 6u : 1u);
}

TEST(LargeScene, NumbersAreFoundBehindCharactersOfSeveralBytes) {
    const Folder folder;
    EXPECT_EQ(folder.scene_error("s.toml", "object = [{name = 'éé', shape = 'box', width = -7}]\n"),
              "s.toml:1: object.width is -7; expected a number from 1e-06 to 1e+06");
    std::string text = "object = [{shape = 'box', name = 'x', translate = [";
    for (int i = 0; i < 100000; ++i) text += "0.5, ";
    EXPECT_EQ(folder.scene_error("s.toml", text + "]}]\n"),
              "s.toml:1: object.translate has 100000 elements; expected an array of 3 numbers");
}

}  // namespace gw::scene
