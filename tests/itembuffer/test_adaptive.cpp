// [K4a] Adaptive sampling on one item buffer: which pixels it divides, and what it misses.
#include "itembuffer/adaptive.h"

#include "itembuffer/superposed_ray_tracer.h"
#include "scene/draw/item_buffer.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace gw::itembuffer {
namespace {

constexpr int width = 160, height = 120;

std::unique_ptr<Machine> machine() { return make_fast(vgx(), width, height); }

scene::Scene fig9() {
    scene::Scene scene =
        scene::read_scene(std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "fig9.toml").scene;
    for (scene::Material& m : scene.materials) m.refl.clear(), m.map_Kd.clear();
    return scene;
}

/// A wall that shines white in front of the eye, over a part of the picture.
raytrace::Walls shining_wall() {
    raytrace::Walls walls;
    walls.scene.camera =
        scene::Camera{.eye = {0, 0, 5}, .near_plane = 0.5, .far_plane = 50, .ortho_height = 5};
    walls.add_shining({0, 0, 0}, {100, 0, 0}, {0, 100, 0}, vec3(1));
    return walls;
}

/// Of an item buffer that shows polygon 1 at one pixel and nothing elsewhere.
AdaptivePicture around_one_pixel(const scene::View& view, int x, int y, int samples) {
    const raytrace::Walls walls = shining_wall();
    const raytrace::World world(walls.scene);
    const raytrace::Tracer tracer(walls.scene, world, view, {.depth = 1});
    std::vector<std::uint32_t> ids(std::size_t(view.width) * std::size_t(view.height));
    ids[view.index(x, y)] = 1;
    return adaptive_picture(tracer, walls.scene, view, ids, samples, vgx());
}

TEST(Adaptive, DividesAPixelAndItsEightNeighbours) {
    const scene::View view = scene::make_view(shining_wall().scene, 7, 5);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const AdaptivePicture drawn = around_one_pixel(view, x, y, 2);
            for (int j = 0; j < view.height; ++j)
                for (int i = 0; i < view.width; ++i) {
                    const bool beside = std::abs(i - x) <= 1 && std::abs(j - y) <= 1;
                    ASSERT_EQ(drawn.divided[view.index(i, j)], beside) << i << ' ' << j;
                }
        }
}

/// A neighbour's polygon that all rays of a pixel go through fills the pixel, from every side.
TEST(Adaptive, CutsTheRaysOfAPixelWithItsNeighboursPolygons) {
    const scene::View view = scene::make_view(shining_wall().scene, 5, 5);
    for (int y = 1; y < 4; ++y)
        for (int x = 1; x < 4; ++x) {
            const AdaptivePicture drawn = around_one_pixel(view, x, y, 4);
            for (int j = 0; j < view.height; ++j)
                for (int i = 0; i < view.width; ++i) {
                    const bool beside = std::abs(i - x) <= 1 && std::abs(j - y) <= 1;
                    ASSERT_EQ(drawn.picture.color[view.index(i, j)][0], beside ? 255 : 0)
                        << i << ' ' << j;
                }
        }
}

/// [K4a] The same needle and crumb by 64 rays at pixels where one item buffer changes, and by the
/// mean of 64 item buffers: the second has their light in proportion to their area, the first only
/// what the one item buffer happened to see.
TEST(Adaptive, MissesWhatOneItemBufferHasNotSeen) {
    const double pixel = 0.1;
    raytrace::Walls walls;
    walls.scene.camera = scene::Camera{
        .eye = {0, 0, 5}, .near_plane = 0.5, .far_plane = 50, .ortho_height = height * pixel};
    walls.scene.lights = {{.direction = {0, 0, -1}, .Ia = vec3(1), .Id = vec3(0)}};
    // Between the centres of pixels: a needle 0.25 pixels wide and 40 high, a crumb of half a
    // pixel.
    walls.add({-2.0f, 0.07f, 0}, {float(0.125 * pixel), 0, 0}, {0, float(20 * pixel), 0});
    walls.add({2.3f, 1.4f, 0}, {float(0.25 * pixel), 0, 0}, {0, float(0.25 * pixel), 0});
    for (scene::Material& m : walls.scene.materials) m = {.Ka = vec3(1), .Kd = vec3(0)};
    const scene::View view = scene::make_view(walls.scene, width, height);
    const auto light_in = [](const std::vector<Rgba>& color) {
        double sum = 0;
        for (const Rgba& c : color) sum += c[0] / 255.0;
        return sum;
    };
    const auto m = machine();
    render_adaptive(*m, walls.scene, view, 64, {});
    EXPECT_EQ(light_in(m->planes().color), 0) << "neither has a pixel's centre in it";
    render(*m, walls.scene, view, {.samples = 64});
    EXPECT_NEAR(light_in(m->planes().color), 40 * 0.25 + 0.25, 0.05 * 10);
    // Moved over the centres of a column of pixels, the needle is seen: its pixels and those beside
    // them are divided, and it has the light of its area.
    walls.scene.objects[0].world_from_object[3].x += 0.053;
    render_adaptive(*m, walls.scene, view, 64, {});
    EXPECT_NEAR(light_in(m->planes().color), 40 * 0.25, 0.05 * 10);
}

TEST(Adaptive, DividesPixelsWhoseNeighboursDiffer) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const auto ids = scene::draw_item_buffer(*m, scene, view, {});
    const raytrace::World world(scene);
    const raytrace::Tracer tracer(scene, world, view, {.depth = 1});
    const AdaptivePicture one = adaptive_picture(tracer, scene, view, ids, 1, vgx()),
                          four = adaptive_picture(tracer, scene, view, ids, 4, vgx());
    EXPECT_EQ(std::count(one.divided.begin(), one.divided.end(), 1), 0);
    EXPECT_EQ(one.picture.counts.primary, ids.size());
    const auto divided = std::uint64_t(std::count(four.divided.begin(), four.divided.end(), 1));
    EXPECT_GT(divided, ids.size() / 4);
    EXPECT_LT(divided, ids.size());
    EXPECT_EQ(four.picture.counts.primary, ids.size() + 3 * divided);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (four.divided[i]) continue;
        ASSERT_EQ(four.picture.color[i], one.picture.color[i]);
    }
}

}  // namespace
}  // namespace gw::itembuffer
