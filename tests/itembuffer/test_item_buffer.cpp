// [K4, K4i] The item buffer and what is traced from it, against the ordinary ray tracer.
#include "scene/draw/item_buffer.h"

#include "gw/fast/simd/simd_target.h"
#include "itembuffer/differences.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "itembuffer/traced_component.h"
#include "multipass/frame/samples.h"
#include "raytrace/tracer/render.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace gw::itembuffer {
namespace {

constexpr int width = 160, height = 120;

scene::Scene fig9() {
    scene::Scene scene =
        scene::read_scene(std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "fig9.toml").scene;
    for (scene::Material& m : scene.materials) m.refl.clear(), m.map_Kd.clear();
    return scene;
}

std::unique_ptr<Machine> machine() { return make_fast(vgx(), width, height); }

/// Whether all neighbours of a pixel show the same polygon.
bool away_from_edges(const std::vector<std::uint32_t>& ids, std::size_t i) {
    const auto x = int(i % width), y = int(i / width);
    if (x == 0 || y == 0 || x == width - 1 || y == height - 1) return false;
    for (const int step : {-1, 1, -width, width})
        if (ids[std::size_t(int(i) + step)] != ids[i]) return false;
    return true;
}

TEST(ItemBuffer, IsTheSameInSeveralPasses) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const auto whole = scene::draw_item_buffer(*m, scene, view, {});
    EXPECT_GT(*std::max_element(whole.begin(), whole.end()), 70000u);
    for (const int bits : {1, 5, 8, 17}) {
        const std::size_t before = m->passes().size();
        EXPECT_EQ(scene::draw_item_buffer(*m, scene, view, {}, bits), whole) << bits;
        EXPECT_EQ(m->passes().size() - before, std::size_t((17 + bits - 1) / bits)) << bits;
    }
}

/// A needle and a crumb, both a small part of a pixel wide: [K4a] 64 item buffers, moved by less
/// than a pixel, find them in proportion to their area; one finds of them what chance gives, and
/// adaptive sampling, which divides pixels whose neighbours differ, has nothing to go by where one
/// item buffer sees none of them.
TEST(ItemBuffer, ManyFindWhatIsSmallerThanAPixelInProportionToItsArea) {
    const double pixel = 0.1;  // world units
    raytrace::Walls walls;
    walls.scene.camera = scene::Camera{
        .eye = {0, 0, 5}, .near_plane = 0.5, .far_plane = 50, .ortho_height = height * pixel};
    const double needle_width = 0.25 * pixel, needle_height = 40 * pixel, crumb = 0.5 * pixel;
    walls.add({-2.13f, 0.07f, 0}, {float(needle_width / 2), 0, 0},
              {0, float(needle_height / 2), 0});
    walls.add({2.33f, 1.38f, 0}, {float(crumb / 2), 0, 0}, {0, float(crumb / 2), 0});
    const scene::View view = scene::make_view(walls.scene, width, height);
    const auto m = machine();
    std::array<double, 3> found{};
    constexpr std::size_t count = 64;
    int empty_for_adaptive = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const auto ids = scene::draw_item_buffer(
            *m, walls.scene, view, multipass::jitter_of({k, count}, vgx().subpixel_bits));
        for (const std::uint32_t id : ids) found[id] += 1.0 / count;
        empty_for_adaptive += std::count(ids.begin(), ids.end(), 2u) == 0;
    }
    const double needle_area = needle_width * needle_height / (pixel * pixel),
                 crumb_area = crumb * crumb / (pixel * pixel);
    EXPECT_NEAR(found[1], needle_area, needle_area * 0.02);
    EXPECT_NEAR(found[2], crumb_area, crumb_area * 0.02);
    EXPECT_EQ(empty_for_adaptive, 48)
        << "of 64: where the crumb is in no pixel, no neighbours differ";
}

TEST(Differences, AccountForEveryPixel) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const Differences d = differences(*m, scene, view, {});
    std::size_t pixels = 0;
    for (const Reason reason : reasons) pixels += count_of(d, reason).pixels;
    EXPECT_EQ(pixels, std::size_t(width) * height);
    EXPECT_GT(d.away_from_edges, std::size_t(width) * height / 4);
    EXPECT_EQ(d.another_polygon_there, 0u);
    EXPECT_EQ(count_of(d, Reason::Same).largest, 0);
    EXPECT_EQ(count_of(d, Reason::Fog).pixels, 0u);
    EXPECT_LE(count_of(d, Reason::Rounding).largest, d.passes);
    for (std::size_t i = 0; i < d.units.size(); ++i) {
        int units = 0;
        for (std::size_t c = 0; c < 3; ++c)
            units = std::max(units, std::abs(int(d.by_passes[i][c]) - int(d.by_rays[i][c])));
        ASSERT_EQ(d.units[i], units);
        ASSERT_EQ(d.reason[i] == Reason::Same, units == 0);
    }
}

TEST(Differences, AreOfAnotherPolygonExactlyWhereThePolygonsDiffer) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const Differences d = differences(*m, scene, view, {});
    const auto ids = scene::draw_item_buffer(*m, scene, view, {});
    const raytrace::World world(scene);
    const auto rays = raytrace::raytraced_picture({scene, world, view, {}}, scene, view, {}, vgx());
    for (std::size_t i = 0; i < ids.size(); ++i)
        ASSERT_EQ(d.reason[i] == Reason::Polygon, d.units[i] > 0 && ids[i] != rays.ids[i]) << i;
    EXPECT_GT(count_of(d, Reason::Polygon).pixels, 0u);
}

TEST(ItemBuffer, ShowsThePolygonThatRaysFindAwayFromEdges) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const raytrace::World world(scene);
    const raytrace::Tracer tracer(scene, world, view, {.depth = 1});
    for (const JitterState& jitter : {JitterState{}, JitterState{3, -2}}) {
        const auto ids = scene::draw_item_buffer(*m, scene, view, jitter);
        const auto rays = raytrace::raytraced_picture(tracer, scene, view, jitter, vgx());
        int compared = 0, different = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (!away_from_edges(ids, i)) continue;
            ++compared;
            different += ids[i] != rays.ids[i];
        }
        EXPECT_GT(compared, width * height / 4);
        EXPECT_EQ(different, 0);
    }
}

/// Snapping may leave a pixel's centre outside its polygon; the plane is met all the same.
TEST(TracedComponent, TracesEveryPixelOfAPolygonThatReflectsAndNoOther) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const raytrace::World world(scene);
    const raytrace::Tracer tracer(scene, world, view, {});
    const auto ids = scene::draw_item_buffer(*m, scene, view, {});
    const TracedComponent traced = traced_component(tracer, scene, view, ids, {}, vgx());
    const scene::PolygonIds numbers = scene::polygon_ids(scene);
    std::uint64_t glossy = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto polygon = scene::polygon_of(numbers, ids[i]);
        if (polygon &&
            raytrace::is_traced(scene.materials[scene.objects[polygon->object].material]))
            ++glossy;
        else
            EXPECT_EQ(traced.color[i], (Rgba{0, 0, 0, 0}));
    }
    EXPECT_GT(glossy, std::uint64_t(width * height / 4));
    EXPECT_EQ(traced.counts.primary, glossy);
    EXPECT_EQ(traced.counts.reflected, glossy);
    EXPECT_LE(traced.counts.shadow, 2 * glossy) << "only reflected hits ask for shadows";
}

TEST(TracedComponent, HasTheSameBitsForAllThreadsAndTargets) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    const auto m = machine();
    const auto ids = scene::draw_item_buffer(*m, scene, view, {});
    const auto trace = [&](int threads) {
        const raytrace::World world(scene, threads);
        const raytrace::Tracer tracer(scene, world, view, {.depth = 3, .threads = threads});
        return traced_component(tracer, scene, view, ids, {}, vgx());
    };
    const TracedComponent one = trace(1);
    for (const std::string& name : fast::simd_targets()) {
        ASSERT_TRUE(fast::use_simd_target(name));
        const TracedComponent other = trace(3);
        EXPECT_EQ(other.color, one.color) << name;
        EXPECT_EQ(other.counts, one.counts) << name;
    }
    fast::use_simd_target("");
}

/// Without lights that vary over a polygon both renderers have the same colours, but for one
/// rounding a pass: two ambient ones and the traced one.
TEST(Eq5, AgreesWithTheOrdinaryRayTracerWhereVertexLightingIsExact) {
    scene::Scene scene = fig9();
    for (scene::Light& light : scene.lights) light.Id = vec3(0), light.Is = vec3(0);
    const scene::View view = scene::make_view(scene, width, height);
    const auto passes = machine(), rays = machine();
    render(*passes, scene, view, {}, {.depth = 3});
    superpose_ray_traced(*rays, scene, view, 1, {.depth = 3});
    const auto ids = scene::draw_item_buffer(*machine(), scene, view, {});
    int compared = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (!away_from_edges(ids, i)) continue;
        ++compared;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(passes->planes().color[i][c], rays->planes().color[i][c], 2) << i;
    }
    EXPECT_GT(compared, width * height / 4);
}

TEST(Eq5, EntersAsAPassOfItsOwn) {
    const scene::Scene scene = fig9();
    const auto m = machine();
    render(*m, scene, scene::make_view(scene, width, height), {});
    const auto& passes = m->passes();
    const auto pass = std::find_if(passes.begin(), passes.end(),
                                   [](const PassReport& p) { return p.name == "raytracing"; });
    ASSERT_NE(pass, passes.end());
    EXPECT_EQ(pass->counters.written, std::uint64_t(width * height));
}

TEST(Eq5, IsEq2WhereNothingAsksForRays) {
    scene::Scene scene = fig9();
    for (scene::Material& m : scene.materials) m.illum = 2;
    const scene::View view = scene::make_view(scene, width, height);
    const auto with = machine(), without = machine();
    render(*with, scene, view, {});
    multipass::render(*without, scene, view, {});
    EXPECT_EQ(with->planes(), without->planes());
}

/// The traced light of a mirror in linear fog is what is left of it at the mirror [K3.5].
TEST(Eq5, ShinesThroughTheFirstHitsBlackFog) {
    raytrace::Walls walls;
    walls.add_shining({0, 0, 10}, {-9, 0, 0}, {0, 9, 0}, vec3(1));
    scene::Material& mirror = walls.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    mirror.Ks = vec3(1);
    mirror.illum = 3;
    const auto m = machine();
    const scene::View view = scene::make_view(walls.scene, width, height);
    const std::size_t middle = std::size_t(height / 2 * width + width / 2);
    for (const float fog : {0.0f, 0.4f}) {
        walls.scene.fog = scene::Fog{.color = vec3(fog), .start = 0, .end = 20};
        render(*m, walls.scene, view, {});
        EXPECT_NEAR(m->planes().color[middle][0], 255 * (0.75 + 0.25 * fog), 1);  // 5 of 20 away
    }
}

/// What is blended over the mirror, and the fog's own colour, come after what the mirror shows.
TEST(Eq5, ComesBeforeWhatLiesOverIt) {
    raytrace::Walls walls;
    scene::Material& mirror = walls.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    mirror.Ks = vec3(1);
    mirror.illum = 3;
    walls.add({0, 0, 1}, {1, 0, 0}, {0, 1, 0}).d = 0.5f;
    walls.scene.fog = scene::Fog{};
    for (const auto translucency :
         {multipass::Translucency::Sorted, multipass::Translucency::Unsorted,
          multipass::Translucency::Layers}) {
        const multipass::PassList list = passes_with_tracing(walls.scene, translucency);
        const auto of_translucent = [](const multipass::Pass& p) {
            return p.objects == multipass::PassObjects::Translucent;
        };
        const auto traced = std::find_if(list.begin(), list.end(),
                                         [](const auto& p) { return p.name == "raytracing"; });
        ASSERT_NE(traced, list.end());
        EXPECT_GT(traced - list.begin(), 1) << "after the depth and a component";
        EXPECT_EQ(traced->fog, multipass::PassFog::Black) << "as gw passes prints it";
        EXPECT_TRUE(std::none_of(list.begin(), traced, of_translucent));
        EXPECT_TRUE(std::any_of(traced, list.end(), of_translucent));
        EXPECT_NE(std::find_if(traced, list.end(), [](const auto& p) { return p.name == "fog"; }),
                  list.end());
    }
}

/// The mirror of a later sample shows where things are then.
TEST(Eq5, TracesWhatHasMovedWhereItIs) {
    raytrace::Walls walls;
    walls.add_shining({0, 0, 10}, {-2, 0, 0}, {0, 2, 0}, vec3(1));
    scene::Material& mirror = walls.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    mirror.Ks = vec3(1);
    mirror.illum = 3;
    const auto m = machine();
    const scene::View view = scene::make_view(walls.scene, width, height);
    scene::Scene moved = walls.scene;
    moved.objects[0].world_from_object[3].x += 3;
    const multipass::Trace trace = tracing(walls.scene, {});
    const auto first = trace(*m, walls.scene, view, {}), then = trace(*m, moved, view, {});
    EXPECT_NE(then, first);
    EXPECT_EQ(then, tracing(moved, {})(*m, moved, view, {}));
    EXPECT_EQ(trace(*m, walls.scene, view, {}), first);

    const auto traced_in = [&](const scene::Scene& world) {
        return tracing(walls.scene, {.world = std::make_shared<raytrace::World>(world)});
    };
    EXPECT_NE(traced_in(moved)(*m, walls.scene, view, {}), first) << "the world is not used";
    const multipass::Trace at_hand = traced_in(walls.scene);
    EXPECT_EQ(at_hand(*m, walls.scene, view, {}), first);
    EXPECT_EQ(at_hand(*m, moved, view, {}), then);
}

TEST(Eq5, ReadsThePassesShadowMapsWhereAsked) {
    const scene::Scene scene = fig9();
    const scene::View view = scene::make_view(scene, width, height);
    raytrace::RayCounts by_rays, by_maps;
    const auto a = machine(), b = machine();
    render(*a, scene, view, {}, {.counts = &by_rays});
    render(*b, scene, view, {}, {.shadow_maps = true, .counts = &by_maps});
    EXPECT_GT(by_rays.shadow, 1000u);
    EXPECT_EQ(by_maps.shadow, 0u);
    int differ = 0;
    for (std::size_t i = 0; i < a->planes().color.size(); ++i)
        differ += a->planes().color[i] != b->planes().color[i];
    EXPECT_LT(differ, width * height / 20) << "shadow borders only";
}

}  // namespace
}  // namespace gw::itembuffer
