// Claims: generated normals follow smoothing groups and the crease angle, split vertices only where
// faces disagree, and are never zero or NaN.
#include "scene/obj/normals.h"

#include <gtest/gtest.h>

#include "scene/geometry/weld.h"
#include "tests/scene/folder.h"

#include <cmath>
#include <set>
#include <tuple>

namespace gw::scene {
namespace {

// Two squares that share the edge from (1,0,0) to (1,1,0); the second is turned down by the angle
// whose tangent is `drop`.
std::string roof(const std::string& drop) {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 -" + drop + "\nv 2 1 -" + drop + "\n";
}
constexpr auto roof_faces = "f 1 2 3 4\nf 2 5 6 3\n";

std::size_t vertices(Folder& folder, const std::string& text, std::optional<double> crease = {}) {
    return folder.obj(text, {crease}).parts[0].mesh.positions.size();
}

}  // namespace

TEST(Normals, AreTheFacesOwnWhereItIsFlat) {
    Folder folder;
    const MeshData mesh = folder.obj(triangle + "f 1 2 3\n").parts[0].mesh;
    EXPECT_EQ(mesh.normals, std::vector<vec3>(3, vec3(0, 0, 1)));
    EXPECT_EQ(folder.obj(triangle + "f 3 2 1\n").parts[0].mesh.normals,
              std::vector<vec3>(3, vec3(0, 0, -1)));
}

TEST(Normals, OfAConcaveFaceFollowItsMeanPlane) {
    Folder folder;
    const MeshData mesh =
        folder.obj("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 3 4 1 2\n").parts[0].mesh;
    EXPECT_EQ(mesh.normals, std::vector<vec3>(4, vec3(0, 0, 1)));
}

TEST(Normals, AreSmoothWithinTheCreaseAngleOnly) {
    Folder folder;
    EXPECT_EQ(vertices(folder, roof("1") + roof_faces), 6u);    // 45 degrees
    EXPECT_EQ(vertices(folder, roof("1.7") + roof_faces), 6u);  // 59.5
    EXPECT_EQ(vertices(folder, roof("1.8") + roof_faces), 8u);  // 60.9
    EXPECT_EQ(vertices(folder, roof("1") + roof_faces, 44.9), 8u);
    EXPECT_EQ(vertices(folder, roof("1.8") + roof_faces, 61), 6u);
    EXPECT_EQ(vertices(folder, roof("0") + roof_faces, 0),
              6u);  // coplanar faces are one surface at any angle
    EXPECT_EQ(vertices(folder, roof("1") + roof_faces, 0), 8u);
}

// Triangles around one point on a steep cone, each with the given statement before it.
std::string cone(int faces, bool with_groups) {
    std::string text = "v 0 0 2000\n";
    for (int i = 0; i < faces; ++i) {
        const double turn = 6.283185307179586 * i / faces;
        text += "v " + std::to_string(1000 * std::cos(turn)) + " " +
                std::to_string(1000 * std::sin(turn)) + " 0\n";
    }
    for (int i = 0; i < faces; ++i) {
        if (with_groups) text += "s " + std::to_string(1 + i / 2) + "\n";
        text += "f 1 " + std::to_string(i + 2) + " " + std::to_string((i + 1) % faces + 2) + "\n";
    }
    return text;
}

std::size_t normals_at_the_tip(const std::string& text) {
    Folder folder;
    const MeshData mesh = folder.obj(text).parts[0].mesh;
    std::set<std::tuple<float, float, float>> normals;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i].z == 2000)
            normals.insert({mesh.normals[i].x, mesh.normals[i].y, mesh.normals[i].z});
    return normals.size();
}

TEST(Normals, OfVeryManySmoothingGroupsAtOnePointAreOneForEachGroup) {
    EXPECT_EQ(normals_at_the_tip(cone(20000, true)), 10000u);
}

TEST(Normals, OfVeryManyFacesAtOnePointAreTheFacesOwn) {
    EXPECT_EQ(normals_at_the_tip("s off\n" + cone(1500, false)),
              normals_at_the_tip(cone(1500, false)));
    EXPECT_EQ(normals_at_the_tip(cone(8, false)), 8u);
    Folder folder;
    folder.obj("s off\n" + cone(1500, false));
    EXPECT_EQ(folder.warnings(), std::vector<std::string>());
    folder.obj(cone(1500, false));
    EXPECT_EQ(folder.warnings(),
              std::vector<std::string>{
                  "m.obj:1502: more than 1024 faces meet at a corner of this one and stay flat "
                  "there; expected normals (vn) or a smoothing group (s)"});
}

TEST(Normals, AreWeightedByArea) {
    Folder folder;
    // A floor of area 3 and a wall of area 4 share an edge: the sum is (0, 4, 3) / 5.
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 1 -3 0\nv 0 -3 0\nv 0 0 -4\nv 1 0 -4\nf 4 3 2 1\nf 1 2 6 5\n";
    const MeshData mesh = folder.obj(text, {90.0}).parts[0].mesh;
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.normals[2], vec3(0, 0.8f, 0.6f));
    EXPECT_EQ(mesh.normals[0], vec3(0, 0, 1));
}

TEST(Normals, FollowSmoothingGroups) {
    Folder folder;
    const std::string a = "f 1 2 3 4\n", b = "f 2 5 6 3\n";
    EXPECT_EQ(vertices(folder, roof("9") + "s 1\n" + a + b), 6u);  // one group, however sharp
    EXPECT_EQ(vertices(folder, roof("9") + "s on\n" + a + b), 6u);
    EXPECT_EQ(vertices(folder, roof("1") + "s 1\n" + a + "s 2\n" + b), 8u);
    EXPECT_EQ(vertices(folder, roof("1") + "s off\n" + a + b), 8u);
    EXPECT_EQ(vertices(folder, roof("1") + "s 0\n" + a + b), 8u);
    // flat and coplanar: nothing to split
    EXPECT_EQ(vertices(folder, roof("0") + "s off\n" + a + b), 6u);
    // an angle asked for overrides them
    EXPECT_EQ(vertices(folder, roof("1") + "s off\n" + a + b, 60), 6u);
}

TEST(Normals, AreSmoothAcrossMaterialsAndRepeatedPositions) {
    Folder folder;
    const std::string text = roof("1") + "v 1 0 -0\nv 1 1 0\ng a\nf 1 2 3 4\ng b\nf 7 5 6 8\n";
    const ObjFile file = folder.obj(text);
    EXPECT_EQ(file.parts[0].mesh.normals[1], file.parts[1].mesh.normals[0]);
    EXPECT_NE(file.parts[0].mesh.normals[1], file.parts[0].mesh.normals[0]);
}

TEST(Normals, FillOnlyWhatIsMissing) {
    Folder folder;
    const MeshData mesh = folder.obj(triangle + "vn 1 0 0\nf 1//1 2 3\n").parts[0].mesh;
    EXPECT_EQ(mesh.normals, (std::vector<vec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
    EXPECT_EQ(folder.obj(triangle + "vn 0 0 0\nf 1//1 2//1 3//1\n").parts[0].mesh.normals,
              std::vector<vec3>(3, vec3(0, 0, 1)));
    EXPECT_EQ(folder.warnings(),
              (Strings{"m.obj:4: vn of length 0: the faces' own normals stand in"}));
}

TEST(Normals, AreUnitForFacesWithoutArea) {
    Folder folder;
    const std::string alone = "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 1\n";
    EXPECT_EQ(folder.obj(alone).parts[0].mesh.normals, std::vector<vec3>(3, vec3(0, 0, 1)));
    const MeshData beside =
        folder.obj("v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2 3\nf 1 2 2\n").parts[0].mesh;
    EXPECT_EQ(beside.normals, std::vector<vec3>(3, vec3(0, -1, 0)));
    EXPECT_EQ(beside.positions.size(), 3u);
}

TEST(Normals, AreUnitWhereASmoothingGroupFoldsBackOnItself) {
    Folder folder;
    const MeshData mesh = folder.obj("s 1\n" + triangle + "f 1 2 3\nf 3 2 1\n").parts[0].mesh;
    EXPECT_EQ(
        mesh.normals,
        (std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}}));
}

TEST(Normals, DoNotDependOnTheModelsSize) {
    Folder folder;
    for (const std::string size : {"1e-40", "1e-7", "1", "1e6", "1e38"}) {
        const MeshData mesh =
            folder.obj("v 0 0 0\nv " + size + " 0 0\nv 0 0 " + size + "\nf 1 2 3\n").parts[0].mesh;
        EXPECT_EQ(mesh.normals, std::vector<vec3>(3, vec3(0, -1, 0))) << size;
    }
}

TEST(Normals, OfATetrahedronAreRadial) {
    Folder folder;
    const std::string text =
        "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
    const MeshData mesh = folder.obj(text, {180.0}).parts[0].mesh;
    ASSERT_EQ(mesh.positions.size(), 4u);
    const auto third = static_cast<float>(1 / std::sqrt(3.0));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.normals[i], mesh.positions[i] * third) << i;
}

TEST(Weld, FindsTheFirstOfEqualPositions) {
    const std::vector<vec3> positions{
        {0, 0, 0}, {1, 2, 3}, {-0.0f, 0, -0.0f}, {1, 2, 3.0000002f}, {1, 2, 3}};
    EXPECT_EQ(weld(positions), (std::vector<std::uint32_t>{0, 1, 0, 3, 1}));
    EXPECT_TRUE(weld(std::vector<vec3>{}).empty());
}

}  // namespace gw::scene
