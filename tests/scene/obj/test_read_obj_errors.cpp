// Claims: each malformed OBJ file is one message with its line, what is wrong and what was
// expected.
#include <gtest/gtest.h>

#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

constexpr auto v_forms = "expected v x y z, v x y z w, v x y z r g b or v x y z r g b a";

struct ObjError : testing::Test {
    Folder folder;
    std::string after_triangle(const std::string& statement) {
        return folder.obj_error(triangle + statement + "\n");
    }
};

}  // namespace

TEST_F(ObjError, NumbersThatAreNone) {
    EXPECT_EQ(folder.obj_error("v abc 1 2\n"),
              std::string("m.obj:1: 'abc' is not a number; ") + v_forms);
    EXPECT_EQ(folder.obj_error("\nv nan 0 0\n"),
              std::string("m.obj:2: 'nan' is not finite; ") + v_forms);
    EXPECT_EQ(folder.obj_error("v 0 -inf 0\n"),
              std::string("m.obj:1: '-inf' is not finite; ") + v_forms);
    EXPECT_EQ(folder.obj_error("v 0 0 1e39\n"),
              std::string("m.obj:1: '1e39' is too large; ") + v_forms);
    EXPECT_EQ(folder.obj_error("v 1,5 0 0\n"),
              std::string("m.obj:1: '1,5' is not a number; ") + v_forms);
    EXPECT_EQ(folder.obj_error("vt x\n"),
              "m.obj:1: 'x' is not a number; expected vt s, vt s t or vt s t r");
}

TEST_F(ObjError, NumbersThatAreNotFiniteCountWhereTheyAreUsed) {
    for (const std::string nan : {"nan", "-nan(ind)", "inf", "1.#QNAN", "-1.#IND"}) {
        const std::string bad = "vn " + nan + " 0 0\nvt " + nan + "\nv 0 0 " + nan + "\n";
        const std::string text = triangle + "vt 0 0\nvn 0 0 1\n" + bad;
        EXPECT_EQ(folder.obj_error(text + "f 1/1/1 2/1/1 3/1/1\n"), "no error") << nan;
        const std::string fault = " '" + nan + "' is not finite; expected ";
        EXPECT_EQ(folder.obj_error(text + "f 1/1/1 2/1/1 3/1/2\n"),
                  "m.obj:6:" + fault + "vn x y z");
        EXPECT_EQ(folder.obj_error(text + "f 1/1/1 2/2/1 3/1/1\n"),
                  "m.obj:7:" + fault + "vt s, vt s t or vt s t r");
        EXPECT_EQ(folder.obj_error(text + "f 1 2 4\n"), "m.obj:8:" + fault + (v_forms + 9));
    }
    EXPECT_EQ(after_triangle("v nan x 0\nf 1 2 3"),
              std::string("m.obj:4: 'nan' is not finite; ") + v_forms);
}

TEST_F(ObjError, MissingAndSurplusCoordinates) {
    EXPECT_EQ(folder.obj_error("v 1 2\n"), std::string("m.obj:1: v has 2 numbers; ") + v_forms);
    EXPECT_EQ(folder.obj_error("v 1 2 3 4 5\n"),
              std::string("m.obj:1: v has 5 numbers; ") + v_forms);
    EXPECT_EQ(folder.obj_error("v 1 2 3 4 5 6 7 8\n"),
              std::string("m.obj:1: v has 8 numbers; ") + v_forms);
    EXPECT_EQ(folder.obj_error("vn 1\n"), "m.obj:1: vn has 1 number; expected vn x y z");
    EXPECT_EQ(folder.obj_error("vt\n"),
              "m.obj:1: vt has 0 numbers; expected vt s, vt s t or vt s t r");
}

TEST_F(ObjError, IndicesOutOfRange) {
    EXPECT_EQ(after_triangle("f 1 2 4"),
              "m.obj:4: v index 4 is out of range; expected 1 .. 3 or -3 .. -1");
    EXPECT_EQ(after_triangle("f 1 2 0"),
              "m.obj:4: v index 0 is out of range; expected 1 .. 3 or -3 .. -1");
    EXPECT_EQ(after_triangle("f 1 2 -4"),
              "m.obj:4: v index -4 is out of range; expected 1 .. 3 or -3 .. -1");
    EXPECT_EQ(after_triangle("f 1/1 2/1 3/1"),
              "m.obj:4: vt index 1 is out of range; the file has no vt");
    EXPECT_EQ(after_triangle("f 1//1 2//1 3//1"),
              "m.obj:4: vn index 1 is out of range; the file has no vn");
    EXPECT_EQ(folder.obj_error("f 1 2 3\n"),
              "m.obj:1: v index 1 is out of range; the file has no v");
    EXPECT_EQ(after_triangle("f 1 2 99999999999"),
              "m.obj:4: '99999999999' is not a corner; expected v, v/vt, v//vn or v/vt/vn");
}

TEST_F(ObjError, CornersThatAreNone) {
    for (const std::string word : {"a", "1/a", "1//a", "1/1/1/1", "1.5", "1/2x", "/1", "1-"})
        EXPECT_EQ(folder.obj_error(triangle + "vt 0 0\nvt 0 0\nvn 0 0 1\nf 1 2 " + word),
                  "m.obj:7: '" + word + "' is not a corner; expected v, v/vt, v//vn or v/vt/vn");
}

TEST_F(ObjError, ElementsWithTooFewCorners) {
    EXPECT_EQ(after_triangle("f 1 2"), "m.obj:4: f has 2 corners; expected at least 3");
    EXPECT_EQ(after_triangle("f"), "m.obj:4: f has 0 corners; expected at least 3");
    EXPECT_EQ(after_triangle("l 1"), "m.obj:4: l has 1 corner; expected at least 2");
    EXPECT_EQ(after_triangle("p"), "m.obj:4: p has 0 corners; expected at least 1");
}

TEST_F(ObjError, NothingToDraw) {
    EXPECT_EQ(folder.obj_error(""), "m.obj: has nothing to draw; expected f, l or p statements");
    EXPECT_EQ(folder.obj_error(triangle),
              "m.obj: has nothing to draw; expected f, l or p statements");
}

TEST_F(ObjError, UnknownStatements) {
    EXPECT_EQ(after_triangle("usemlt red"),
              "m.obj:4: unknown statement 'usemlt'; the nearest known is 'usemtl'");
    EXPECT_EQ(after_triangle("s smooth"),
              "m.obj:4: s has 'smooth'; expected off, on or a number from 0");
    EXPECT_EQ(after_triangle("s -1"), "m.obj:4: s has '-1'; expected off, on or a number from 0");
}

TEST_F(ObjError, Libraries) {
    EXPECT_EQ(folder.obj_error("mtllib\n"), "m.obj:1: mtllib names no file; expected one or more");
    std::filesystem::create_directory(folder.path() / "d");
    EXPECT_EQ(folder.obj_error("mtllib d\n"),
              "m.obj:1: mtllib 'd' is a directory; expected an MTL file");
    EXPECT_EQ(folder.obj_error("mtllib /dev/null\n"),
              "m.obj:1: mtllib '/dev/null' is a device or a pipe; expected an MTL file");
    std::string words = "mtllib";
    for (int i = 0; i < 100000; ++i) words += " a";
    EXPECT_EQ(folder.obj_error(words + "\n"),
              "m.obj:1: mtllib has too many words; expected fewer than 1000");
}

TEST_F(ObjError, LinesAreCountedThroughContinuations) {
    EXPECT_EQ(folder.obj_error("v 0 0 \\\n0\nv 1 2\n"),
              std::string("m.obj:3: v has 2 numbers; ") + v_forms);
    EXPECT_EQ(folder.obj_error("v 0 0 0\r\nv 1 \\\r\n2\r\n"),
              std::string("m.obj:2: v has 2 numbers; ") + v_forms);
}

TEST_F(ObjError, FilesThatAreNoScene) {
    EXPECT_EQ(folder.error([&] { read_scene(folder.path() / "no.obj"); }),
              "no.obj: cannot be opened: No such file or directory; expected a readable file");
    std::filesystem::create_directory(folder.path() / "d.obj");
    EXPECT_EQ(folder.error([&] { read_scene(folder.path() / "d.obj"); }),
              "d.obj: is a directory; expected a file");
    EXPECT_EQ(folder.scene_error("a.png", "x"),
              "a.png: has the extension '.png'; expected .toml, .obj, .gltf or .glb");
}

}  // namespace gw::scene
