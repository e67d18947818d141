// Claims: known points land on known pixels.
#include "scene/draw/view.h"

#include "gw/error.h"
#include "scene/draw/fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::scene {
namespace {

dvec4 times(const dmat4& m, const dvec4& v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3] * v.w;
}

/// Normalised device coordinates of a point in the world.
dvec3 device(const View& view, const dvec3& p) {
    const dvec4 clip = times(view.clip_from_eye, times(view.eye_from_world, dvec4(p, 1)));
    return dvec3(clip) / clip.w;
}

Bounds box(double low, double high) { return {dvec3(low), dvec3(high), false}; }

constexpr double exactly = 1e-12;

TEST(View, LooksAlongMinusZWithYUp) {
    const View view = make_view({.eye = {0, 0, 5}, .at = {0, 0, 0}}, box(-1, 1), 64, 64);
    EXPECT_EQ(times(view.eye_from_world, dvec4(1, 2, 3, 1)), dvec4(1, 2, -2, 1));
}

TEST(View, PutsTheEdgesOfTheFieldOfViewOnTheEdgesOfTheWindow) {
    const Camera camera{
        .eye = {0, 0, 4}, .at = {0, 0, 0}, .fov = 90, .near_plane = 1, .far_plane = 9};
    const View view = make_view(camera, box(-1, 1), 200, 100);
    EXPECT_NEAR(device(view, {0, 4, 0}).y, 1, exactly);
    EXPECT_NEAR(device(view, {8, 0, 0}).x, 1, exactly);
    EXPECT_NEAR(device(view, {0, 0, 3}).z, -1, exactly);
    EXPECT_NEAR(device(view, {0, 0, -5}).z, 1, exactly);
}

TEST(View, OrthographicShowsItsHeight) {
    const Camera camera{
        .eye = {0, 0, 4}, .at = {0, 0, 0}, .near_plane = 1, .far_plane = 9, .ortho_height = 6};
    const View view = make_view(camera, box(-1, 1), 200, 100);
    EXPECT_NEAR(device(view, {6, 3, 2}).x, 1, exactly);
    EXPECT_NEAR(device(view, {6, 3, -2}).y, 1, exactly);
    EXPECT_NEAR(device(view, {0, 0, -5}).z, 1, exactly);
}

TEST(View, KeepsTheWholeSceneBetweenFittedPlanesAtEveryScale) {
    for (double scale = 1e-7; scale < 1e7; scale *= 10) {
        const Bounds bounds{dvec3(-scale, -2 * scale, -scale), dvec3(scale, scale, 3 * scale),
                            false};
        const View view =
            make_view({.eye = dvec3(5, 3, 9) * scale, .at = dvec3(0)}, bounds, 64, 48);
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 p(corner & 1 ? bounds.high.x : bounds.low.x,
                          corner & 2 ? bounds.high.y : bounds.low.y,
                          corner & 4 ? bounds.high.z : bounds.low.z);
            EXPECT_LT(std::abs(device(view, p).z), 1) << "scale " << scale << ", corner " << corner;
        }
    }
}

TEST(View, FitsPlanesWithTheEyeInsideTheScene) {
    const View view = make_view({.eye = {0, 0, 0.5}, .at = {0, 0, 0}}, box(-1, 1), 64, 64);
    EXPECT_GT(view.camera.near_plane, 0);
    EXPECT_LE(view.camera.near_plane, view.camera.far_plane / 1000);
    EXPECT_GT(view.camera.far_plane, 1.5);
}

TEST(View, KeepsPlanesThatAreGiven) {
    const View view = make_view({.near_plane = 0.25, .far_plane = 77}, box(-1, 1), 64, 64);
    EXPECT_EQ(view.camera.near_plane, 0.25);
    EXPECT_EQ(view.camera.far_plane, 77);
}

TEST(View, WithPlanesIsTheViewMadeWithThem) {
    for (const double height : {0.0, 6.0}) {
        const Camera camera{
            .eye = {1, 2, 4}, .near_plane = 1, .far_plane = 9, .ortho_height = height};
        Camera deeper = camera;
        deeper.near_plane = 0.5;
        deeper.far_plane = 50;
        const View moved = with_planes(make_view(camera, box(-1, 1), 200, 100), 0.5, 50);
        const View made = make_view(deeper, box(-1, 1), 200, 100);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                EXPECT_NEAR(moved.clip_from_eye[column][row], made.clip_from_eye[column][row],
                            exactly);
    }
}

TEST(View, TakesAnyUpParallelToTheLineOfSight) {
    for (const dvec3& axis : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(1, 0, 0), dvec3(0, 0, 1)}) {
        const dmat4 m = look_at(axis * 3.0, dvec3(0), axis);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                EXPECT_NEAR(dot3(dvec3(m[i]), dvec3(m[j])), i == j ? 1 : 0, exactly);
    }
}

TEST(View, RefusesACameraThatLooksAtItself) {
    EXPECT_THROW(make_view({.eye = {1, 2, 3}, .at = {1, 2, 3}}, box(-1, 1), 64, 64), Error);
    EXPECT_THROW(make_view(Camera{}, box(-1, 1), 0, 64), Error);
}

TEST(CubeViews, HaveMatricesOfZerosAndOnes) {
    for (const View& view : cube_views({1, 2, 3}, 0.5, 100, 32)) {
        EXPECT_EQ(view.clip_from_eye[0], dvec4(1, 0, 0, 0));
        EXPECT_EQ(view.clip_from_eye[1], dvec4(0, 1, 0, 0));
        EXPECT_EQ(view.clip_from_eye[2].w, -1);
        for (int column = 0; column < 3; ++column) {
            double sum = 0;
            for (int row = 0; row < 3; ++row) sum += std::abs(view.eye_from_world[column][row]);
            EXPECT_EQ(sum, 1);
        }
        EXPECT_EQ(times(view.eye_from_world, dvec4(1, 2, 3, 1)), dvec4(0, 0, 0, 1));
    }
}

TEST(CubeViews, SeeEveryDirectionOnce) {
    const auto views = cube_views({0, 0, 0}, 0.5, 100, 32);
    for (int x = -7; x <= 7; x += 2)
        for (int y = -6; y <= 6; y += 4)
            for (int z = -5; z <= 5; z += 2) {
                if (std::abs(x) == std::abs(y) || std::abs(y) == std::abs(z) ||
                    std::abs(x) == std::abs(z))
                    continue;
                int seen = 0;
                for (const View& view : views) {
                    const dvec4 clip =
                        times(view.clip_from_eye, times(view.eye_from_world, dvec4(x, y, z, 1)));
                    seen += clip.w > 0 && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
                }
                EXPECT_EQ(seen, 1) << x << " " << y << " " << z;
            }
}

TEST(FitCamera, ShowsTheWholeSceneAtEveryScaleAndNotMuchMore) {
    for (double scale = 1e-7; scale < 1e7; scale *= 10)
        for (const ivec2& size : {ivec2(640, 480), ivec2(100, 300), ivec2(64, 64)}) {
            const Bounds bounds{dvec3(3, -1, -2) * scale, dvec3(5, 2, 2) * scale, false};
            const View view = make_view(fit_camera(bounds, size.x, size.y), bounds, size.x, size.y);
            double farthest = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const dvec3 p = device(view, {corner & 1 ? bounds.high.x : bounds.low.x,
                                              corner & 2 ? bounds.high.y : bounds.low.y,
                                              corner & 4 ? bounds.high.z : bounds.low.z});
                farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
            }
            EXPECT_LT(farthest, 1);
            EXPECT_GT(farthest, 0.8);
        }
}

TEST(FitCamera, SeesASinglePointAndAnEmptyScene) {
    EXPECT_NO_THROW(make_view(fit_camera({dvec3(2), dvec3(2), false}, 64, 64),
                              {dvec3(2), dvec3(2), false}, 64, 64));
    EXPECT_NO_THROW(make_view(fit_camera({}, 64, 64), {}, 64, 64));
}

TEST(DefaultLight, ComesFromBehindTheViewer) {
    const Camera camera{.eye = {10, 0, 0}, .at = {0, 0, 0}};
    const Light light = default_light(camera);
    EXPECT_LT(light.direction.x, 0);  // away from the viewer
    EXPECT_LT(light.direction.y, 0);  // downwards
}

TEST(AddDefaults, ChangesNothingThatTheSceneSays) {
    Scene scene;
    scene.camera = Camera{.eye = {1, 1, 1}};
    scene.lights.push_back({.name = "own"});
    add_defaults(scene, 64, 64);
    EXPECT_EQ(scene.camera->eye, dvec3(1, 1, 1));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].name, "own");
}

TEST(AddDefaults, LeavesAGlowingSceneUnlit) {
    Scene scene;
    scene.materials.push_back({.Ke = vec3(1)});
    add_defaults(scene, 64, 64);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(scene.camera.has_value());
}

TEST(Turntable, TurnsTheEyeAboutAt) {
    const Camera start{.eye = {5, 1, 1}, .at = {1, 1, 1}};
    const Camera quarter = turntable(start, 90);
    EXPECT_NEAR(quarter.eye.x, 1, 1e-12);
    EXPECT_NEAR(quarter.eye.y, 1, 1e-12);
    EXPECT_NEAR(quarter.eye.z, -3, 1e-12);
    EXPECT_EQ(turntable(start, 360).eye, start.eye);
}

TEST(Turntable, TakesAnUpOfAnyLength) {
    const Camera start{.eye = {5, 1, 1}, .at = {1, 1, 1}, .up = {0, 3, 4}};
    Camera longer = start;
    longer.up = {0, 6, 8};
    EXPECT_EQ(turntable(start, 60).eye, turntable(longer, 60).eye);
    const dvec3 arm = turntable(start, 60).eye - start.at;
    EXPECT_NEAR(dot3(arm, arm), 16, 1e-12);
}

TEST(OverrideCamera, ReplacesWhatIsGiven) {
    const Camera camera = override_camera({.eye = {1, 2, 3}, .fov = 40}, {.eye = dvec3(9, 9, 9)});
    EXPECT_EQ(camera.eye, dvec3(9, 9, 9));
    EXPECT_EQ(camera.fov, 40);
}

}  // namespace
}  // namespace gw::scene
