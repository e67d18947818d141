// Claims [K4f]: the study's counts are those of closed forms (n lights, one mirror, a quad); they are
// the same twice and for any number of threads, and on any compiler; the extreme scenes count as they
// must; sweeps vary what they say and nothing else.
#include "gw/names.h"
#include "render/study/divided.h"
#include "render/study/sweeps.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::render {
namespace {

constexpr int side = 16;
constexpr std::uint64_t pixels = side * side;

void silent(const std::string&) {}

/// A mirror that fills the window, seen along its normal, and `lights` that shine on it from the eye's
/// side and cast shadows.
scene::Scene mirror(int lights, int illum = 3) {
    raytrace::Walls walls;
    walls.scene.camera = scene::Camera{
        .eye = {0, 0, 5}, .at = {0, 0, 0}, .near_plane = 1, .far_plane = 9, .ortho_height = 2};
    scene::Material& m = walls.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    m.Kd = vec3(0.5f);
    m.Ks = illum >= 3 ? vec3(0.5f) : vec3(0);
    m.illum = illum;
    for (int i = 0; i < lights; ++i)
        walls.scene.lights.push_back({.name = "sun " + std::to_string(i),
                                      .direction = {0, 0, -1},
                                      .shadow = scene::Shadow::Volume});
    return walls.scene;
}

Drawing drawing_of(scene::Scene scene, int threads = 1) {
    Request request{.size = {side, side}, .threads = threads};
    return make_drawing(request, vgx(), {.scene = std::move(scene)});
}

StudyRow row_of(scene::Scene scene, int threads = 1) {
    return measured(no_sweep(), 1, drawing_of(std::move(scene), threads), 0, silent);
}

std::vector<std::uint64_t> counts_of(const StudyRow& row) {
    std::vector<std::uint64_t> all;
    for (const Cost& cost : row.costs) {
        all.push_back(cost.passes.size());
        const Counters sum = cost.sum();
        for (const CounterName& counter : counter_names()) all.push_back(sum.*counter.count);
        const raytrace::RayCounts& r = cost.rays;
        for (const std::uint64_t n : {r.primary, r.reflected, r.transmitted, r.shadow, r.shaded,
                                      r.tests.boxes, r.tests.triangles, cost.picture.low})
            all.push_back(n);
    }
    return all;
}

/// Balls over a floor; two lamps.
scene::Scene balls() {
    raytrace::Walls walls;
    walls.scene.camera = scene::Camera{.eye = {0, 2, 6}, .at = {0, 0.4, 0}, .fov = 40};
    scene::Material& floor = walls.add({0, 0, 0}, {3, 0, 0}, {0, 0, -3});
    floor.Kd = vec3(0.7f);
    for (const float x : {-0.8f, 0.8f}) {
        scene::Material& pane = walls.add({x, 0.6f, 0}, {0.5f, 0, 0.2f}, {0, 0.5f, 0});
        pane.Kd = vec3(0.3f);
        pane.Ks = vec3(0.5f);
        pane.illum = 3;
        walls.scene.lights.push_back({.kind = scene::LightKind::Point,
                                      .position = {2 * x, 4, 3},
                                      .Id = vec3(0.5f),
                                      .shadow = scene::Shadow::Volume});
    }
    return walls.scene;
}

TEST(PassStudy, AMirrorAndNLightsCountAsTheirClosedForm) {
    for (const int lights : {1, 2, 5}) {
        const StudyRow row = row_of(mirror(lights));
        const auto &ordinary = row.cost("ray-tracing").rays, &item = row.cost("item-buffer").rays;
        EXPECT_EQ(ordinary.primary, pixels);
        EXPECT_EQ(ordinary.reflected, pixels);
        EXPECT_EQ(ordinary.shadow, std::uint64_t(lights * pixels));
        EXPECT_EQ(ordinary.shaded, pixels);
        // One node with the two triangles in its only leaf: every ray tests its eight boxes.
        EXPECT_EQ(ordinary.tests.boxes, std::uint64_t(8 * (2 + lights) * pixels));
        EXPECT_EQ(item.primary, pixels);
        EXPECT_EQ(item.reflected, pixels);
        EXPECT_EQ(item.shadow, 0u) << "the passes have the shadows of first hits";
        EXPECT_EQ(item.shaded, 0u) << "no reflected ray hits anything";
        EXPECT_EQ(item.tests.boxes, std::uint64_t(8 * pixels));
        EXPECT_EQ(row.cost("maps").rays, raytrace::RayCounts{});
        EXPECT_EQ(row.share(), 1);
    }
}

/// Without shadows, as they bring passes of their own.
TEST(PassStudy, EveryLightAddsThePixelsOfItsPasses) {
    const auto fragments = [](int lights) {
        scene::Scene scene = mirror(lights, 2);
        for (scene::Light& light : scene.lights) light.shadow = scene::Shadow::None;
        const Cost cost = row_of(scene).cost("maps");
        // Every pass that draws fills the window once: no fragment twice at the diagonal.
        for (const Counters& pass : cost.passes) EXPECT_EQ(pass.fragments, pass.draws * pixels);
        return cost.sum().fragments;
    };
    const std::uint64_t one = fragments(1), two = fragments(2);
    EXPECT_GE(two - one, std::uint64_t(pixels));
    EXPECT_EQ(fragments(5) - one, 4 * (two - one));
}

TEST(PassStudy, CountsAreTheSameTwiceAndForAllThreads) {
    const std::vector<std::uint64_t> one = counts_of(row_of(balls()));
    EXPECT_EQ(counts_of(row_of(balls())), one);
    EXPECT_EQ(counts_of(row_of(balls(), 3)), one);
}

/// The numbers are of g++ 12 on x86-64; any other compiler has the same.
TEST(PassStudy, CountsAreTheSameOnEveryCompiler) {
    const StudyRow row = row_of(balls());
    const auto &ordinary = row.cost("ray-tracing").rays, &item = row.cost("item-buffer").rays;
    const std::vector<std::uint64_t> found{ordinary.primary,
                                           ordinary.reflected,
                                           ordinary.shadow,
                                           ordinary.shaded,
                                           ordinary.tests.boxes,
                                           ordinary.tests.triangles,
                                           item.primary,
                                           item.reflected,
                                           item.shadow,
                                           item.tests.boxes,
                                           item.tests.triangles,
                                           row.cost("item-buffer").sum().fragments,
                                           row.cost("maps").sum().fragments};
    EXPECT_EQ(found, (std::vector<std::uint64_t>{256, 25, 306, 153, 4696, 3042, 26, 26, 28, 432,
                                                 350, 2036, 1626}));
}

TEST(PassStudy, SumsItsPasses) {
    const Cost cost = row_of(balls()).cost("item-buffer");
    std::uint64_t written = 0;
    for (const Counters& pass : cost.passes) written += pass.written;
    EXPECT_EQ(cost.sum().written, written);
    EXPECT_GT(cost.passes.size(), 5u);
}

TEST(PassStudy, TakesScenesOfNothingGlossyAndNothingVisible) {
    const StudyRow matte = row_of(mirror(2, 2));
    EXPECT_EQ(matte.share(), 0);
    EXPECT_EQ(matte.cost("item-buffer").rays, raytrace::RayCounts{});
    EXPECT_EQ(matte.cost("item-buffer").picture, matte.cost("maps").picture);
    scene::Scene behind = mirror(2);
    behind.camera->at = {0, 0, 10};
    const StudyRow none = row_of(behind);
    EXPECT_EQ(none.share(), 0);
    EXPECT_EQ(none.cost("maps").sum().written, 0u);
    EXPECT_EQ(none.cost("ray-tracing").rays.shadow, 0u);
    EXPECT_EQ(none.cost("ray-tracing").rays.primary, pixels);
}

TEST(PassStudy, LaterRunsAreTimedAndChangeNoCount) {
    const StudyRow once = measured(no_sweep(), 1, drawing_of(balls()), 0, silent),
                   more = measured(no_sweep(), 1, drawing_of(balls()), 3, silent);
    EXPECT_EQ(counts_of(more), counts_of(once));
    for (const Cost& cost : more.costs) {
        EXPECT_EQ(cost.seconds.size(), 3u);
        EXPECT_LE(cost.least(), cost.median());
        EXPECT_LE(cost.median(), cost.most());
    }
    EXPECT_TRUE(once.costs[0].seconds.empty());
}

TEST(PassSweeps, VaryWhatTheySay) {
    const Drawing drawing = drawing_of(balls());
    for (const Sweep& sweep : sweeps()) {
        EXPECT_EQ(sweep.refusal(drawing), "") << sweep.name;
        EXPECT_TRUE(std::ranges::is_sorted(sweep.values)) << sweep.name;
        EXPECT_GE(sweep.values.front(), sweep.low) << sweep.name;
        EXPECT_LE(sweep.values.back(), sweep.high) << sweep.name;
    }
    const auto row = [&](const char* name, int value) {
        return measured(*std::ranges::find(sweeps(), name, &Sweep::name), value, drawing, 0,
                        silent);
    };
    EXPECT_EQ(row("lights", 5).lights, 5);
    EXPECT_EQ(row("lights", 1).lights, 1);
    EXPECT_EQ(row("samples", 4).cost("ray-tracing").rays.primary, std::uint64_t(4 * pixels));
    EXPECT_EQ(row("share", 0).share(), 0);
    EXPECT_GT(row("share", 100).share(), 0.2);
    EXPECT_LE(row("share", 30).share(), 0.3);
    EXPECT_EQ(row("polygons", 2).triangles, 6u * 16u);
    EXPECT_EQ(row("resolution", 32).x, 32 * 32);
    EXPECT_EQ(row("depth", 1).cost("item-buffer").rays.reflected, 0u);
}

TEST(PassSweeps, RefuseWhatTheSceneLacks) {
    raytrace::Walls empty;
    empty.scene.lights.push_back({.name = "sun"});
    const Drawing drawing = drawing_of(empty.scene);
    for (const char* name : {"share", "polygons", "depth"})
        EXPECT_NE(std::ranges::find(sweeps(), name, &Sweep::name)->refusal(drawing), "") << name;
}

TEST(PassSweeps, LightsAreTogetherAsBrightAndAtPlacesOfTheirOwn) {
    const scene::Scene scene = with_lights(balls(), 7);
    vec3 sum(0);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        sum += scene.lights[i].Id;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(scene.lights[i].position, scene.lights[j].position) << i << " " << j;
    }
    EXPECT_NEAR(sum.x, 1, 1e-5);
}

TEST(Divided, KeepsTheSurfacesInFourTimesTheTriangles) {
    const scene::Scene scene = balls();
    const scene::Scene parts = divided(scene, 3);
    EXPECT_EQ(divided(scene, 0).objects[0].mesh, scene.objects[0].mesh);
    std::size_t triangles = 0;
    double area = 0;
    for (const scene::Object& object : parts.objects)
        for (const Triangle& t : object.mesh->triangles()) {
            const auto& p = object.mesh->data().positions;
            const dvec3 a(p[t.vertex[0]]), b(p[t.vertex[1]]), c(p[t.vertex[2]]);
            area += length(cross3(b - a, c - a)) / 2;
            ++triangles;
        }
    EXPECT_EQ(triangles, 6u * 64u);
    EXPECT_NEAR(area, 36 + 2 * length(cross3(dvec3(1, 0, 0.4), dvec3(0, 1, 0))), 1e-4);
}

}  // namespace
}  // namespace gw::render
