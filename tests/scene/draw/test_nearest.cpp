// Claims: fitted planes cut off nothing that the window shows, however far the scene reaches; if depth
// cannot reach so far, one line names the object.
#include "scene/draw/nearest.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

Object quad(const std::string& name, double z, float half = 1) {
    return {.name = name,
            .mesh = make_mesh({.primitive = Primitive::Quads,
                               .positions = {{-half, -half, 0},
                                             {half, -half, 0},
                                             {half, half, 0},
                                             {-half, half, 0}}}),
            .world_from_object = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, z, 1}}};
}

/// A square 5 before the eye, and another one behind it.
Scene square_before(double far_away) {
    Scene scene{.name = "s"};
    scene.objects = {quad("square", 0), quad("far", -far_away)};
    scene.materials.resize(1);
    scene.camera = Camera{.eye = {0, 0, 5}, .at = {0, 0, 0}};
    return scene;
}

TEST(FittedView, ComesBeforeWhatStandsInTheWindow) {
    for (const double far_away : {1e2, 1e4, 2e4, 1e5, 2e5}) {
        const Scene scene = square_before(far_away);
        const View view = make_view(scene, 64, 48);
        EXPECT_LT(view.camera.near_plane, 5) << far_away;
        EXPECT_GT(view.camera.far_plane, far_away + 5);
        EXPECT_FALSE(cut_by_near(scene, view));
        EXPECT_EQ(near_warning(scene, view), "");
    }
}

TEST(FittedView, StaysIfNothingStandsBeforeItInTheWindow) {
    Scene scene = square_before(2e5);
    scene.objects[0].world_from_object[3].x = 50;  // beside the window
    const View view = make_view(scene, 64, 48);
    EXPECT_EQ(view.camera.near_plane, view.camera.far_plane / 4096);
    scene.objects[0].world_from_object[3] = {0, 0, 6, 1};  // behind the eye
    EXPECT_EQ(make_view(scene, 64, 48).camera.near_plane,
              make_view(scene, 64, 48).camera.far_plane / 4096);
}

TEST(FittedView, SaysWhatDepthCannotReach) {
    const Scene scene = square_before(1e7);
    const View view = make_view(scene, 64, 48);
    EXPECT_EQ(view.camera.near_plane, view.camera.far_plane / 65536);
    EXPECT_EQ(near_warning(scene, view).substr(0, 70),
              "object 'square' is cut off: it comes as near to the eye as 5, and dept");
    EXPECT_EQ(view_for_rays(scene, view).camera.near_plane, 2.5);
}

TEST(FittedView, RaysBeginBeforeEverything) {
    const Scene scene = square_before(1e7);
    const View view = view_for_rays(scene, make_view(scene, 64, 48));
    const PixelRay ray = PixelRays(view).through(32, 24);
    EXPECT_GT(ray.o.z, 0) << "the square is at 0";
    EXPECT_NEAR(ray.o.x, 0, 1e-6);
    const View near_square = make_view(square_before(100), 64, 48);
    EXPECT_EQ(view_for_rays(square_before(100), near_square).clip_from_eye,
              near_square.clip_from_eye);
}

TEST(FittedView, HonoursAPlaneThatIsGiven) {
    Scene scene = square_before(2e5);
    scene.camera->near_plane = 7;
    const View view = make_view(scene, 64, 48);
    EXPECT_EQ(view.camera.near_plane, 7);
    EXPECT_EQ(near_warning(scene, view), "") << "the file says so";
    EXPECT_EQ(view_for_rays(scene, view).camera.near_plane, 7);
}

/// Only a corner of the floor comes near, at the lower border of the window.
TEST(FittedView, CountsThePartOfAFaceInTheWindow) {
    Scene scene = square_before(1e4);
    scene.objects[0] = quad("floor", 0, 5e3f);
    scene.objects[0].world_from_object = {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, -1, 0, 1}};
    const View view = make_view(scene, 64, 64);
    const double at_border = 1 / 0.36397023426620234;  // 1 / tan(20 degrees)
    EXPECT_NEAR(nearest_in(view, scene, 1e9).distance, at_border, 1e-9);
    EXPECT_LT(view.camera.near_plane, at_border);
    EXPECT_GT(view.camera.near_plane, 0.9 * at_border);
}

TEST(FittedView, HoldsObjectsThatMove) {
    Scene scene = square_before(10);
    scene.objects[0].move = {0, 0, 9.5};   // to 0.25 before the eye
    scene.objects[1].move = {0, 0, -100};  // to 65 behind it
    const View view = make_view(scene, 64, 48);
    EXPECT_LT(view.camera.near_plane, 0.25);
    EXPECT_GT(view.camera.far_plane, 65);
}

TEST(FittedView, CountsLinesAndPoints) {
    for (const Primitive primitive : {Primitive::Lines, Primitive::Points}) {
        Scene scene = square_before(2e5);
        scene.objects[0].mesh =
            make_mesh({.primitive = primitive, .positions = {{0, 0, 1}, {100, 0, 1}}});
        EXPECT_NEAR(nearest_in(make_view(scene, 64, 48), scene, 1e9).distance, 4, 1e-12);
    }
}

TEST(FittedView, OfAnOrthographicCameraSparesWhatStandsBeforeTheEye) {
    Scene scene = square_before(2e5);
    scene.camera->ortho_height = 4;
    EXPECT_LT(make_view(scene, 64, 48).camera.near_plane, 5);
}

}  // namespace
}  // namespace gw::scene
