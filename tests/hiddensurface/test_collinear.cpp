// Claims: polygons with corners on one line lose no pixel in the algorithms that decide in the
// world. A triangle without a plane of its own may get a pixel by the snap.
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::hiddensurface {
namespace {

/// As `gw hidden` shows a file without a camera.
scene::Scene fitted(std::vector<vec3> corners, std::vector<std::uint32_t> sizes) {
    MeshData data{.primitive = Primitive::Polygons};
    data.positions = std::move(corners);
    data.polygon_sizes = std::move(sizes);
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera.reset();
    scene::add_defaults(scene, 32, 24);
    return scene;
}

void expect_right(scene::Scene scene) {
    Trial trial(std::move(scene), vgx(), 32, 24);
    for (const char* name : {"newell", "bsp", "schumacker", "quake"})
        EXPECT_EQ(trial.run(name).counts.wrong, 0u) << name;
}

}  // namespace

TEST(Collinear, TrianglesOfABentPolygonKeepTheirPixels) {
    expect_right(fitted({{-2, 2, -2},
                         {-0.5f, 1.25f, -2},
                         {0, 1, -2},
                         {0, 0.5f, -1.5f},
                         {0, 0, -1},
                         {-1, 0, 0},
                         {-1.5f, 0.5f, 0},
                         {-2, 1, 0},
                         {-2, 1.92483828f, -1.84967656f},
                         {0, 0, -1},
                         {1, 0, -1},
                         {0.5f, 0, -1},
                         {-1, 0, -1}},
                        {9, 4}));
}

TEST(Collinear, PolygonsWithoutAreaKeepTheirPixels) {
    expect_right(fitted({{-1, 0, -1},
                         {0, 0, 0},
                         {0, 0, 0},
                         {1, 0, 1},
                         {1, 0, 1},
                         {0.5f, 0, 0.5f},
                         {0.202808531f, 0, 0.202808531f},
                         {-1, 0, -1},
                         {-1, 0, -1},
                         {-1, 0, -1}},
                        {10}));
}

TEST(Collinear, CornersOfRandomPolygonsLoseNoPixel) {
    Random random(7);
    const auto quarter = [&](double reach) { return std::round(random(-reach, reach) * 4) / 4.0f; };
    for (int scene = 0; scene < 150; ++scene) {
        SCOPED_TRACE(scene);
        std::vector<vec3> corners;
        for (int polygon = 0; polygon < 2; ++polygon) {
            vec3 of[4];
            for (vec3& p : of) {
                const float z = quarter(1), y = quarter(1.5), x = quarter(1.5);
                p = {x, y, z};
            }
            for (int k = 0; k < 4; ++k)
                for (const float t : {0.0f, 0.25f, 0.5f})
                    corners.push_back(of[k] + t * (of[(k + 1) % 4] - of[k]));
        }
        expect_right(fitted(std::move(corners), {12, 12}));
    }
}

}  // namespace gw::hiddensurface
