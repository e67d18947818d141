// Claims: a scene in map coordinates keeps the digits of its text, wherever they are given.
#include "scene/geometry/far.h"

#include <gtest/gtest.h>

#include "tests/scene/folder.h"

#include <cmath>

namespace gw::scene {
namespace {

constexpr double east = 431000.1, north = 5411000.2;

std::string square(double x, double y) {
    std::string text;
    for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {0.3, 0.0}, {0.3, 0.3}, {0.0, 0.3}})
        text += "v " + std::to_string(x + dx) + " " + std::to_string(y + dy) + " 0\n";
    return text + "f 1 2 3 4\n";
}

/// The square beside others in one file.
std::string next_square(double x, double y) {
    std::string text = square(x, y);
    return text.replace(text.find("f 1"), std::string::npos, "f -4 -3 -2 -1\n");
}

/// The corners in the coordinates of the file.
std::vector<dvec3> corners(const SceneFile& file, std::size_t object = 0) {
    std::vector<dvec3> list;
    const Object& o = file.scene.objects.at(object);
    for (const vec3& p : o.mesh->data().positions)
        list.push_back(dvec3(o.world_from_object * dvec4(dvec3(p), 1)) + file.origin);
    return list;
}

/// A mark of the origin, or any stray face, does not cost the others their digits.
TEST(FarScenes, KeepTheirDigitsBesideAStrayFace) {
    const Folder folder;
    std::string text;
    for (int i = 0; i < 16; ++i) text += next_square(east + 0.3 * i, north);
    const SceneFile file =
        read_scene(folder.write("a.obj", text + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"));
    const std::vector<dvec3> found = corners(file);
    ASSERT_EQ(found.size(), 16 * 4u + 3);
    for (int i = 0; i < 16; ++i) {
        EXPECT_NEAR(found[std::size_t(4 * i)].x, east + 0.3 * i, 1e-5);
        EXPECT_NEAR(found[std::size_t(4 * i)].y, north, 1e-5);
    }
    EXPECT_NEAR(found[64].x, 0, 0.5);  // whole, where it is seen from far away
}

/// Two places in one file, so that no point is near both.
TEST(FarScenes, KeepTheirDigitsInEachObject) {
    const Folder folder;
    const SceneFile file = read_scene(
        folder.write("a.obj", "o home\n" + square(0.1, 0.2) + "o far\n" + next_square(east, north) +
                                  "o beside\n" + next_square(east + 0.3, north)));
    EXPECT_EQ(file.warnings, std::vector<std::string>());
    EXPECT_EQ(corners(file, 0)[0].x, double(0.1f));
    for (const std::size_t object : {1u, 2u}) {
        const double x = object == 1 ? east : east + 0.3;
        EXPECT_NEAR(corners(file, object)[0].x, x, 1e-7);
        EXPECT_NEAR(corners(file, object)[2].y, north + 0.3, 1e-7);
    }
    EXPECT_EQ(corners(file, 1)[1], corners(file, 2)[0]) << "faces that meet have one corner";
}

TEST(FarScenes, NameAnObjectThatLiesInTwoPlaces) {
    const Folder folder;
    const SceneFile file =
        read_scene(folder.write("a.obj", square(0, 0) + next_square(east, north)));
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(folder.relative(file.warnings[0]),
              "a.obj:10: object 'a' has parts 5411001 from its middle, where float32 has steps of "
              "0.5; expected objects (o, g) of their own for places so far apart");
}

double largest_coordinate(const Scene& scene) {
    const Bounds b = bounds(scene);
    double most = 0;
    for (int k = 0; k < 3; ++k) most = std::max({most, std::abs(b.low[k]), std::abs(b.high[k])});
    return most;
}

TEST(FarScenes, KeepTheirDigits) {
    const Folder folder;
    const SceneFile file = read_scene(folder.write("a.obj", square(east, north)));
    EXPECT_LT(largest_coordinate(file.scene), 1) << "rays, passes and pixmaps see small numbers";
    const std::vector<dvec3> read = corners(file);
    EXPECT_NEAR(read[0].x, east, 1e-7);
    EXPECT_NEAR(read[2].x, east + 0.3, 1e-7);
    EXPECT_NEAR(read[2].y, north + 0.3, 1e-7);
}

TEST(FarScenes, AreAsTheyWereIfTheyAreNotFar) {
    const Folder folder;
    const SceneFile file = read_scene(folder.write("a.obj", square(4, 4)));
    EXPECT_EQ(file.origin, dvec3(0));
    EXPECT_EQ(file.scene.objects[0].world_from_object, dmat4(1));
    EXPECT_EQ(file.scene.objects[0].mesh->data().positions[0], vec3(4, 4, 0));
}

TEST(FarScenes, MoveCameraLampsAndPlacementsAlike) {
    const Folder folder;
    folder.write("a.obj", square(east, north));
    const SceneFile file = read_scene(folder.write("a.toml", R"(
[camera]
eye = [431000.25, 5411000.35, 2]
at = [431000.25, 5411000.35, 0]
[[light]]
position = [431000.2, 5411000.3, 1.5]
[[light]]
direction = [0, 0, -1]
[[object]]
file = "a.obj"
[[object]]
file = "a.obj"
name = "beside"
translate = [0.6, 0, 0]
[[object]]
shape = "rectangle"
translate = [431000.4, 5411000.5, -1]
)"));
    const Scene& scene = file.scene;
    EXPECT_NEAR(scene.camera->eye.x + file.origin.x, 431000.25, 1e-7);
    EXPECT_NEAR(scene.camera->at.y + file.origin.y, 5411000.35, 1e-7);
    EXPECT_NEAR(double(scene.lights[0].position.x) + file.origin.x, 431000.2, 1e-6);
    EXPECT_NEAR(double(scene.lights[0].position.y) + file.origin.y, 5411000.3, 1e-6);
    EXPECT_EQ(scene.lights[1].direction, vec3(0, 0, -1));
    EXPECT_NEAR(corners(file, 1)[0].x, east + 0.6, 1e-7);
    EXPECT_NEAR(corners(file, 2)[0].x, 431000.4 - 0.5, 1e-7);
    EXPECT_LT(largest_coordinate(scene), 4);
}

TEST(FarScenes, PlacedAtHomeAreAtHome) {
    const Folder folder;
    folder.write("a.obj", square(east, north));
    const SceneFile file = read_scene(folder.write(
        "a.toml", "[[object]]\nfile = 'a.obj'\ntranslate = [-431000.1, -5411000.2, 0]\n"));
    EXPECT_EQ(file.origin, dvec3(0));
    EXPECT_NEAR(corners(file)[2].x, 0.3, 1e-7);
    EXPECT_NEAR(corners(file)[2].y, 0.3, 1e-7);
}

TEST(FarScenes, OfAViewHaveItsCameraBesideThem) {
    const Folder folder;
    folder.write("a.obj", square(east, north));
    const SceneFile file = read_scene(folder.write(
        "v.toml",
        "base = 'a.obj'\n[camera]\neye = [431000, 5411000, 9]\nat = [431000, 5411000, 0]\n"));
    EXPECT_EQ(file.scene.camera->eye + file.origin, dvec3(431000, 5411000, 9));
}

/// A first v at 0 that no face uses is no corner.
TEST(FarScenes, CountOnlyWhatIsUsed) {
    const Folder folder;
    std::string text = square(east, north);
    text.replace(text.find("f 1 2 3 4"), 9, "f 2 3 4 5");
    const SceneFile file = read_scene(folder.write("a.obj", "v 0 0 0\n" + text));
    EXPECT_NEAR(corners(file)[1].x, east + 0.3, 1e-7);
}

}  // namespace
}  // namespace gw::scene
