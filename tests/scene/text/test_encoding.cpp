// Claims: OBJ and MTL files in Shift-JIS are read as their UTF-8 twins are, whatever the last bytes
// of their characters; texts that are neither are refused with their line.
#include "scene/text/encoding.h"

#include <gtest/gtest.h>

#include "scene/text/text_file.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

// "table", "so", "ability": their second byte is a '\'.
const std::string table_sjis = "\x95\x5c", so_sjis = "\x83\x5c";
const std::string table = "表", so = "ソ";

struct Encoding : testing::Test {
    Folder folder;
    Scene scene_of(const std::string& name, const std::string& obj) const {
        return read_scene(folder.write(name, obj)).scene;
    }
};

std::string model(const std::string& library, const std::string& material,
                  const std::string& group) {
    return "mtllib " + library + "\n" + triangle + "usemtl red\nf 1 2 3\ng " + group + "\nusemtl " +
           material + "\nf 1 2 3\n";
}

}  // namespace

TEST_F(Encoding, ACharactersLastByteContinuesNoLine) {
    const std::string materials = "newmtl red\nKd 1 0 0\nnewmtl ";
    folder.write("u.mtl", materials + so + "\nKd 0 0 1\n");
    folder.write("s.mtl", materials + so_sjis + "\nKd 0 0 1\n");
    const Scene utf8 = scene_of("u.obj", model("u.mtl", so, table));
    for (const auto& [name, text] : {std::pair{"s.obj", model("s.mtl", so_sjis, table_sjis)},
                                     {"m.obj", model("u.mtl", so_sjis, table_sjis)},
                                     {"n.obj", model("s.mtl", so, table)}}) {
        const Scene read = scene_of(name, text);
        ASSERT_EQ(read.objects.size(), 2u) << name;
        EXPECT_EQ(read.objects[1].name, table);
        EXPECT_EQ(read.objects[1].name, utf8.objects[1].name);
        EXPECT_EQ(read.materials.at(read.objects[1].material).Kd, vec3(0, 0, 1));
        EXPECT_EQ(read.materials.at(read.objects[1].material).name, so);
    }
}

TEST_F(Encoding, FilesAreFoundByEitherSpelling) {
    folder.write(table_sjis + ".mtl", "newmtl red\nnewmtl b\nmap_Kd " + so + ".png\n");
    folder.write(so_sjis + ".png", "");
    const Scene read = scene_of("a.obj", model(table + ".mtl", "b", "x"));
    EXPECT_EQ(read.materials.at(read.objects[1].material).map_Kd.at(0).file,
              folder.path() / (so_sjis + ".png"));
    folder.write(so + ".png", "");
    EXPECT_EQ(
        scene_of("a.obj", model(table_sjis + ".mtl", "b", "x")).materials.at(1).map_Kd[0].file,
        folder.path() / (so + ".png"));
}

TEST_F(Encoding, TextThatIsNeitherIsRefusedWithItsLine) {
    EXPECT_EQ(folder.obj_error(triangle + "g f\xfcr\nf 1 2 3\n"),
              "m.obj:4: is neither UTF-8 nor Shift-JIS; expected UTF-8 text");
    EXPECT_EQ(folder.obj_error(triangle + "g " + table + "\ng f\xfcr\nf 1 2 3\n"),
              "m.obj:5: is neither UTF-8 nor Shift-JIS; expected UTF-8 text");
}

TEST_F(Encoding, CommentsMayHaveAnyBytes) {
    EXPECT_EQ(folder.obj_error("# f\xfcr\n" + triangle + " # \x95\x5c\nf 1 2 3\n"), "no error");
    const ObjFile file = folder.obj("# f\xfcr\n" + triangle + "g " + table + "\nf 1 2 3\n");
    EXPECT_EQ(file.parts.at(0).name, table) << "a comment does not change the encoding of names";
}

TEST_F(Encoding, WhatDosPutBehindATextIsNoStatement) {
    const std::string zeros(40, '\0');
    for (const std::string& end : {std::string("\x1a"), "\n\x1a" + zeros, zeros})
        EXPECT_EQ(folder.obj(triangle + "f 1 2 3" + end).parts.at(0).mesh.indices.size(), 3u);
    EXPECT_EQ(folder.obj_error(triangle + "f 1 2 3\n\x1a\nf 1 2 3\n"),
              "m.obj:5: unknown statement '\\x1a'; the nearest known is 'v'");
}

/// All first bytes, and second bytes on the borders of their ranges: against glibc's own reading of
/// whole characters.
TEST(LineBeyondUtf8, FindsEveryMalformedSequence) {
    const auto bad = [](const std::string& bytes) {
        return line_beyond_utf8("abcdefgh\n" + bytes + "\n") == 2;
    };
    for (const char* good : {"\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                             "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "z"})
        EXPECT_FALSE(bad(good)) << testing::PrintToString(good);
    for (const char* wrong :
         {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xc2", "\xc2\x7f", "\xc2\xc0", "\xe0\x9f\xbf",
          "\xe1\x80", "\xe1\x80\xc0", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf0\x90\x80",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xfe"})
        EXPECT_TRUE(bad(wrong)) << testing::PrintToString(wrong);
}

TEST(ShiftJisName, IsThatOfWindows) {
    EXPECT_EQ(shift_jis_name("a" + table + ".png"), "a" + table_sjis + ".png");
    EXPECT_EQ(shift_jis_name("a.png"), std::nullopt);
    EXPECT_EQ(shift_jis_name("\xc3\xa9.png"), std::nullopt) << "no such letter in it";
}

}  // namespace gw::scene
