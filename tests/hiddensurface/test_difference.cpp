// Claims: a differing pixel is the snap's only where the scene has the order that is shown, the
// snapped corners have the other, and both are as near to each other as the snap can move them.
// [L5]
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

namespace gw::hiddensurface {
namespace {

/// In this view the grid has 120 units to one of the world, and (0, 0) is on it.
constexpr double unit = 1.0 / 120;

/// z = x + `nearer`, from -1 to 1 but for `off` units in x.
void add_slope(MeshData& data, double nearer, double off) {
    for (const auto& [x, y] :
         {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(1.0, 1.0), std::pair(-1.0, 1.0)})
        data.positions.push_back(
            vec3(float(x + off * unit), float(y), float(x + off * unit + nearer)));
}

/// Polygon 1 before polygon 2, `apart` units of the world; corners this far right of the grid's
/// points.
scene::Scene two_slopes(double apart, double off_1, double off_2) {
    MeshData data{.primitive = Primitive::Quads};
    add_slope(data, apart, off_1);
    add_slope(data, 0, off_2);
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera->ortho_height = 8;
    return scene;
}

constexpr int x = 80, y = 60;

}  // namespace

// The first one's corners move 0.45 units to the right and its surface back, the second one's the
// other way.
TEST(Snap, IsWhatTurnsTwoSurfacesOver) {
    Trial trial(two_slopes(0.4 * unit, 0.55, 0.45));
    const Differences differences(trial.input, {});
    EXPECT_EQ(trial.z_buffer.ids[160 * y + x], 2u);
    EXPECT_EQ(differences.at(1, 2, x, y), Difference::Snap);
    EXPECT_EQ(differences.at(2, 2, x, y), Difference::None);
    EXPECT_EQ(differences.at(0, 2, x, y), Difference::Wrong);
    const Counts tree = trial.run("bsp").counts;
    EXPECT_GT(tree.snapped, 500u);
    EXPECT_EQ(tree.wrong, 0u);
    EXPECT_EQ(trial.run("scan-line").ids, trial.z_buffer.ids);
}

TEST(Snap, ExcusesNothingThatIsBehindInTheScene) {
    Trial trial(two_slopes(0.4 * unit, 0, 0));  // as near to each other, and on the grid
    EXPECT_EQ(trial.z_buffer.ids[160 * y + x], 1u);
    EXPECT_EQ(Differences(trial.input, {}).at(2, 1, x, y), Difference::Wrong);
    EXPECT_EQ(trial.run("bsp").ids, trial.z_buffer.ids);
}

// The depths as drawn are farther apart than half a unit at every corner makes them, whatever the
// scene says.
TEST(Snap, ReachesHalfAUnitAtEveryCorner) {
    Trial trial(two_slopes(-3 * unit, 0, 0));
    EXPECT_EQ(trial.z_buffer.ids[160 * y + x], 2u);
    EXPECT_EQ(Differences(trial.input, {}).at(1, 2, x, y), Difference::Wrong);
}

/// Two neighbours in the rim of scenes/teapot.toml's left bowl, of one surface, as it sees them:
/// almost from their edges, thinner than a unit. The snap alone makes them as wide as a pixel.
scene::Scene rim_of_a_bowl() {
    scene::Scene scene = polygon_scene({.positions = {{-3.58223206f, 1.14496658f, 2.73290804f},
                                                      {-3.61721863f, 1.14496658f, 2.79836329f},
                                                      {-3.61399871f, 1.14640624f, 2.79995118f},
                                                      {-3.57590169f, 1.1471128f, 2.73656288f},
                                                      {-3.61066274f, 1.1471128f, 2.80159627f},
                                                      {-3.60726879f, 1.14705598f, 2.80327001f}}});
    scene.camera = scene::Camera{.eye = {2.2, 5.8, 13}, .at = {-0.05, 1.2, 0}, .fov = 32};
    return scene;
}

// In the scene neither of the two covers the centre of a pixel, and on their planes the one that
// the tree shows lies behind; the snap moves its depth by more than its snapped slopes say.
TEST(Snap, MovesFacetsSeenFromTheEdgeByTheSlopesOfTheScene) {
    Trial trial(rim_of_a_bowl(), vgx(), 320, 240);
    const Result tree = trial.run("bsp");
    EXPECT_EQ(tree.counts.wrong, 0u);
    EXPECT_EQ(tree.counts.snapped, 1u);
    EXPECT_EQ(tree.difference[320 * 93 + 20], Difference::Snap);
    EXPECT_EQ(tree.ids[320 * 93 + 20], 1u);
    EXPECT_EQ(trial.z_buffer.ids[320 * 93 + 20], 2u);
    EXPECT_EQ(trial.run("scan-line").ids, trial.z_buffer.ids);
}

namespace {

/// Two sheets through one line, whose corners are `lift` above and below it.
scene::Scene crossed_sheets(double lift) {
    MeshData data{.primitive = Primitive::Quads};
    for (const float z : {0.0f, float(lift)})
        for (const ivec2& at : {ivec2(-2, -2), ivec2(2, -2), ivec2(2, 2), ivec2(-2, 2)})
            data.positions.push_back(vec3(float(at.x), float(at.y), at.y < 0 ? z : -z));
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera = scene::Camera{.eye = {0, 0, 10}, .at = {0, 0, 0}};
    return scene;
}

}  // namespace

TEST(OnePlane, IsToldOfSheetsThatTheToleranceOfPlanesJoins) {
    Trial trial(crossed_sheets(1e-6));
    for (const char* name : {"newell", "bsp", "schumacker", "quake"}) {
        const Result result = trial.run(name);
        EXPECT_GT(result.counts.wrong, 1000u) << name;
        EXPECT_EQ(result.one_plane.pixels, result.counts.wrong) << name;
        EXPECT_EQ(result.one_plane.pairs, 1u) << name;
        const std::string text = one_plane_warning(name, trial.input, result.one_plane);
        EXPECT_NE(text.find(" 1 of 'polygons' and 2 of 'polygons'"), std::string::npos) << text;
        EXPECT_NE(text.find(std::to_string(result.counts.wrong) + " pixels are wrong, of 1 pair"),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("more than 4e-06 apart"), std::string::npos) << text;
    }
}

TEST(OnePlane, IsNotToldOfOtherMistakesOrOfSheetsFartherApart) {
    EXPECT_EQ(Trial(crossed_sheets(1e-5)).run("bsp").counts.wrong, 0u);
    const Result painter = Trial(case_scene("cycle")).run("painter-centroid");
    EXPECT_GT(painter.counts.wrong, 0u);
    EXPECT_EQ(painter.one_plane.pixels, 0u);
}

}  // namespace gw::hiddensurface
