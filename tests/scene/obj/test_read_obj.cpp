// Claims: real OBJ files become the parts, vertices and indices that they describe.
#include "scene/obj/read_obj.h"

#include "gw/base/cancel.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

using Indices = std::vector<std::uint32_t>;

}  // namespace

TEST(ReadObj, ReadsPositionsToTheBit) {
    Folder folder;
    const MeshData mesh =
        folder.obj("v 0.1 -2.5 1e-7\nv 1e6 +3 .5\nv 0 0 0 1\nf 1 2 3\n").parts[0].mesh;
    EXPECT_EQ(mesh.positions,
              (std::vector<vec3>{{0.1f, -2.5f, 1e-7f}, {1e6f, 3, 0.5f}, {0, 0, 0}}));
    EXPECT_EQ(mesh.primitive, Primitive::Polygons);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.polygon_sizes, (Indices{3}));
    EXPECT_TRUE(mesh.texcoords.empty());
    EXPECT_TRUE(mesh.colors.empty());
}

TEST(ReadObj, KeepsPolygonsWhole) {
    Folder folder;
    const MeshData mesh =
        folder.obj("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\nf 1 2 4\n")
            .parts[0]
            .mesh;
    EXPECT_EQ(mesh.polygon_sizes, (Indices{5, 3}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 3, 4, 0, 1, 3}));
}

TEST(ReadObj, CountsNegativeIndicesFromTheLatest) {
    Folder folder;
    const MeshData mesh = folder.obj(triangle + "f -3 -2 -1\nv 9 9 9\nf -4 -3 -1\n").parts[0].mesh;
    EXPECT_EQ(mesh.positions.back(), vec3(9, 9, 9));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 1, 3}));
}

TEST(ReadObj, TakesVerticesThatComeLater) {
    Folder folder;
    EXPECT_EQ(folder.obj("f 1 2 3\n" + triangle).parts[0].mesh.indices, (Indices{0, 1, 2}));
}

TEST(ReadObj, UnifiesTriplesAndSplitsVerticesWhereTheyDiffer) {
    Folder folder;
    const std::string text = triangle + "v 1 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\n";
    const MeshData mesh =
        folder.obj(text + "f 1/1/1 2/2/1 3/1/1\nf 3/1/1 2/2/1 4/1/1\nf 1/1/2 2/2/1 3/2/1\n")
            .parts[0]
            .mesh;
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 2, 1, 3, 4, 1, 5}));
    EXPECT_EQ(mesh.normals[4], vec3(0, 1, 0));
    EXPECT_EQ(mesh.texcoords[5], vec2(1, 0));
    EXPECT_EQ(mesh.positions[5], vec3(0, 1, 0));
}

TEST(ReadObj, TakesEveryFormOfACorner) {
    Folder folder;
    const std::string text = triangle + "vt 0.5\nvt 0.25 0.75 9\nvn 0 0 2\n";
    const MeshData mesh =
        folder.obj(text + "f 1/1 2/2 3\nf 1//1 2//1 3//1\nf 1/1/1 2/-1/-1 3/2/1\n").parts[0].mesh;
    EXPECT_EQ(mesh.texcoords[0], vec2(0.5f, 0));
    EXPECT_EQ(mesh.texcoords[1], vec2(0.25f, 0.75f));
    EXPECT_EQ(mesh.texcoords[2], vec2(0, 0));
    EXPECT_EQ(mesh.normals[3], vec3(0, 0, 2));  // as given: the machine normalises
    EXPECT_EQ(folder.obj(text + "f 1// 2// 3//\n").parts[0].mesh.indices, (Indices{0, 1, 2}));
}

TEST(ReadObj, ReadsVertexColours) {
    Folder folder;
    const MeshData mesh =
        folder.obj("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 0 0 1 0.25\nv 5 5 5\nf 1 2 3 4\n")
            .parts[0]
            .mesh;
    EXPECT_EQ(mesh.colors,
              (std::vector<vec4>{{1, 1, 1, 1}, {1, 0.5f, 0, 1}, {0, 0, 1, 0.25f}, {1, 1, 1, 1}}));
    EXPECT_EQ(mesh.positions[2], vec3(0, 1, 0));
}

TEST(ReadObj, MakesAPartForEachNameAndMaterial) {
    Folder folder;
    folder.write("m.mtl", "newmtl red\nnewmtl deep blue\n");
    const std::string faces = "f 1 2 3\n";
    const ObjFile file =
        folder.obj("mtllib m.mtl\n" + triangle + faces + "o car\n" + faces +
                   "g wheel left\nusemtl red\n" + faces + "usemtl deep blue\n" + faces + "g\n" +
                   faces + "g wheel left\nusemtl red\n" + faces + "o bus\n" + faces);
    Strings parts;
    for (const ObjPart& part : file.parts)
        parts.push_back(part.name + "|" + part.material + "|" +
                        std::to_string(part.mesh.polygon_sizes.size()));
    EXPECT_EQ(parts, (Strings{"m||1", "car||1", "wheel left|red|2", "wheel left|deep blue|1",
                              "car|deep blue|1", "bus|red|1"}));
    EXPECT_EQ(file.parts[2].material_line, 9);
}

TEST(ReadObj, MakesPartsOfLinesAndPoints) {
    Folder folder;
    const ObjFile file = folder.obj(triangle + "l 1 2 3\nf 1 2 3\np 3 1\nl 3/ 1\n");
    ASSERT_EQ(file.parts.size(), 3u);
    EXPECT_EQ(file.parts[0].mesh.primitive, Primitive::Lines);
    EXPECT_EQ(file.parts[0].mesh.indices, (Indices{0, 1, 1, 2, 2, 0}));
    EXPECT_TRUE(file.parts[0].mesh.normals.empty());
    EXPECT_EQ(file.parts[2].mesh.primitive, Primitive::Points);
    EXPECT_EQ(file.parts[2].mesh.indices, (Indices{0, 1}));
    EXPECT_EQ(file.parts[2].mesh.positions, (std::vector<vec3>{{0, 1, 0}, {0, 0, 0}}));
}

TEST(ReadObj, ReadsBytesOfAnyEditor) {
    Folder folder;
    const ObjFile file = folder.obj(
        "\xef\xbb\xbf# caf\xc3\xa9\r\nv 0 0 0 # origin\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 \\\r\n 2 \\\r\n 3\r\n");
    EXPECT_EQ(file.parts[0].mesh.indices, (Indices{0, 1, 2}));
}

TEST(ReadObj, FindsLibrariesWithBlanksAndSeveralOnALine) {
    Folder folder;
    folder.write("my first.mtl", "newmtl a\n");
    folder.write("sub/b.mtl", "newmtl b\n");
    folder.write("C.mtl", "newmtl c\n");
    const ObjFile file =
        folder.obj("mtllib my first.mtl sub\\b.mtl\nmtllib c.mtl\nmtllib sub/b.mtl\n" + triangle +
                   "f 1 2 3\n");
    Strings names;
    for (const Material& material : file.materials.materials) names.push_back(material.name);
    EXPECT_EQ(names, (Strings{"a", "b", "c"}));
    EXPECT_EQ(folder.warnings(), Strings());
}

TEST(ReadObj, EndsWhenItsCallerSaysSo) {
    Folder folder;
    std::string text;
    for (int i = 0; i < 5000; ++i) text += "v 0 0 0\n";
    const std::atomic<bool> cancel = true;
    const CancelScope scope(&cancel);
    EXPECT_THROW(folder.obj(text + "no statement\n"), Canceled);
}

TEST(ReadObj, WarnsOfALibraryThatIsMissingIfNothingNeedsIt) {
    Folder folder;
    folder.write("b.mtl", "newmtl b\n");
    EXPECT_EQ(folder.obj("mtllib no such.mtl\n" + triangle + "f 1 2 3\n").parts.size(), 1u);
    EXPECT_EQ(folder.warnings(),
              Strings{"m.obj:1: mtllib 'no such.mtl' does not exist; expected an MTL file"});
    const ObjFile file =
        folder.obj("mtllib not there.mtl b.mtl\n" + triangle + "usemtl b\nf 1 2 3\n");
    EXPECT_EQ(file.materials.materials.size(), 1u);
    EXPECT_EQ(folder.warnings(),
              Strings{"m.obj:1: mtllib 'not there.mtl' does not exist; expected an MTL file"});
}

TEST(ReadObj, TakesVeryManyGroupsAndVerticesAtOnePoint) {
    Folder folder;
    std::string groups = triangle, corners = triangle;
    for (int i = 0; i < 20000; ++i) {
        groups += "g part" + std::to_string(i) + "\nf 1 2 3\n";
        corners += "vt " + std::to_string(i) + "\nf 1/-1 2 3\n";
    }
    const ObjFile parts = folder.obj(groups);
    ASSERT_EQ(parts.parts.size(), 20000u);
    EXPECT_EQ(parts.parts[19999].name, "part19999");
    EXPECT_EQ(parts.parts[19999].mesh.positions.size(), 3u);
    const MeshData mesh = folder.obj(corners).parts[0].mesh;
    ASSERT_EQ(mesh.positions.size(), 20000u + 2u);
    EXPECT_EQ(mesh.indices[3 * 19999], 20001u);
    EXPECT_EQ(mesh.texcoords[20001].x, 19999);
}

TEST(ReadObj, WarnsOncePerKindOfWhatItDoesNotDraw) {
    Folder folder;
    folder.obj(triangle + "vp 0 1\nvp 1 1\ncstype bezier\nv 0 0 0 0.5\nf 1 2 3\n");
    EXPECT_EQ(folder.warnings(), (Strings{"m.obj:4: vp statements are not drawn",
                                          "m.obj:6: cstype statements are not drawn",
                                          "m.obj:7: the weight w of v is not used"}));
}

TEST(ReadObj, TakesKeywordsInAnyCase) {
    Folder folder;
    const ObjFile file = folder.obj(
        "V 0 0 0\nV 1 0 0\nv 0 1 0\nVT 0 0\nVN 0 0 1\nG a\nUSEMTL (null)\nF 1/1/1 2/1/1 3/1/1\n");
    EXPECT_EQ(file.parts.at(0).name, "a");
    EXPECT_EQ(file.parts.at(0).mesh.positions.size(), 3u);
    EXPECT_EQ(folder.warnings(), Strings());
}

TEST(ReadObj, WarnsOfMaterialsThatCannotBeSeen) {
    Folder folder;
    folder.write("m.mtl", "newmtl a\nTr 1\nnewmtl unused\nd 0\nnewmtl b\nd 0.1\n");
    const auto file = folder.write(
        "s.obj", "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    Strings lines = read_scene(file).warnings;
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(folder.relative(lines[0]),
              "s.obj: material 'a' is invisible (d 0, or Tr 1); expected d above 0");
}

}  // namespace gw::scene
