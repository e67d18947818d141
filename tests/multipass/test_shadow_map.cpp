// Shadow maps against rays, and against shadow volumes.
#include "multipass/shadow/shadow_lookup.h"
#include "multipass/shadow/shadow_map.h"
#include "scene/draw/item_buffer.h"
#include "scene/draw/view.h"

#include "tests/multipass/shadow_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

scene::Scene mapped(Case c) {
    c.s.lights[0].shadow = scene::Shadow::Map;
    return c.s;
}

Case spot(double cone) {
    Case c;
    c.lamp({1.5f, 4, 1});
    c.s.lights[0].kind = scene::LightKind::Spot;
    c.s.lights[0].direction = {-0.4f, -1, -0.2f};
    c.s.lights[0].cone_angle = cone;
    return c;
}

TEST(ShadowMap, OfADirectionalLight) { expect_true(mapped(Case())); }
TEST(ShadowMap, OfAPointLightInSixFaces) { expect_true(mapped(Case().lamp({1.5f, 3, 1}))); }
TEST(ShadowMap, OfASpotInOneView) {
    EXPECT_EQ(light_views(spot(50).s.lights[0], scene::bounds(spot(50).s), 64).size(), 1u);
    EXPECT_EQ(light_views(spot(80).s.lights[0], scene::bounds(spot(80).s), 64).size(), 6u);
    expect_true(mapped(spot(80)));
}
TEST(ShadowMap, OfAnyMesh) {
    for (const MeshRef& mesh :
         {open_box_mesh(), wings_mesh(), shape("torus", {{"segments", 12}, {"sides", 8}})}) {
        expect_true(mapped(Case(mesh)));
        expect_true(mapped(Case(mesh).lamp({1.5f, 3, 1})));
    }
}
TEST(ShadowMap, OnEveryProfile) {
    for (const Profile& profile : paper_profiles()) expect_true(mapped(Case()), profile);
}

/// 16,000 below the floor: all else is within a 4096th of its distance.
scene::Scene with_a_far_body(scene::Scene s) {
    s.objects.push_back({.name = "far", .mesh = box_mesh()});
    s.objects.back().world_from_object[3] = dvec4(0, -16000, 0, 1);
    return s;
}
TEST(ShadowMap, OfAFarReachHasWhatIsNear) {
    expect_true(with_a_far_body(mapped(Case().lamp({1.5f, 3, 1}))));
    expect_true(with_a_far_body(mapped(spot(50))));
    expect_true(with_a_far_body(mapped(spot(80))));
}

TEST(ShadowMap, DoesNotShadeWhatNothingHides) {
    // Light that grazes the floor: a bias too small would leave stripes.
    Case c;
    c.s.objects.pop_back();
    for (const float height : {1.0f, 0.3f, 0.1f, 0.03f}) {
        c.s.lights[0].direction = {-1, -height, 0.3f};
        c.s.lights[0].shadow = scene::Shadow::Map;
        const auto machine = make_reference(vgx(), window_width, window_height);
        render(*machine, c.s, scene::make_view(c.s, window_width, window_height), {});
        const auto& stencil = machine->planes().stencil;
        EXPECT_EQ(std::count(stencil.begin(), stencil.end(), 0), std::ptrdiff_t(stencil.size()))
            << height;
    }
}

TEST(ShadowMap, FollowsTheJitter) {
    // The mask of a picture that was moved by a pixel is the mask, moved by a pixel.
    const scene::Scene s = mapped(Case());
    const scene::View view = scene::make_view(s, window_width, window_height);
    const PassModel model = make_pass_model(s);
    const auto machine = make_reference(vgx(), window_width, window_height);
    const auto maps =
        draw_shadow_maps(*machine, model, light_views(s.lights[0], scene::bounds(s), 256),
                         window_width, window_height);
    const auto mask = [&](const JitterState& jitter) {
        return shadow_mask(scene::WorldTriangles(s), s.lights[0], maps,
                           scene::draw_item_buffer(*machine, *model.scene, view, jitter), view,
                           jitter, vgx());
    };
    const auto still = mask({}), moved = mask({.x = 7, .y = 0}), back = mask({.x = -7, .y = 0});
    int differ = 0, common = 0;
    for (std::size_t i = 0; i < still.size(); ++i) {
        differ += still[i] != moved[i] || still[i] != back[i];
        common += still[i] == 1;
    }
    EXPECT_GT(common, 50);
    EXPECT_GT(differ, 0);
    EXPECT_LT(differ, common) << "only along borders";
}

TEST(ShadowMap, IsTheSameFromTilesAsFromOneWindow) {
    const scene::Scene s = mapped(Case());
    const PassModel model = make_pass_model(s);
    const auto views = light_views(s.lights[0], scene::bounds(s), 128);
    const auto small = make_reference(vgx(), 50, 37), large = make_reference(vgx(), 128, 128);
    EXPECT_EQ(draw_shadow_maps(*small, model, views, 50, 37)[0].depth,
              draw_shadow_maps(*large, model, views, 128, 128)[0].depth);
}

/// Where a point is in a view, -1 .. 1 in the window and between the planes.
dvec3 place_in(const scene::View& view, const dvec3& p) {
    const dvec4 c = view.clip_from_eye * (view.eye_from_world * dvec4(p, 1));
    return dvec3(c) / c.w;
}

scene::Light point_light(const vec3& position) {
    return {.kind = scene::LightKind::Point, .position = position};
}

/// The nearest point is a corner in a corner of a face's view: there the plane is farther along the
/// axis than anywhere else at this distance.
TEST(LightViews, OfAPointLightHoldWhatIsNearestAndFarthest) {
    const scene::Bounds bounds{dvec3(1), dvec3(3), false};
    const auto views = light_views(point_light(vec3(0)), bounds, 64);
    ASSERT_EQ(views.size(), 6u);
    for (const int face : {0, 2, 4}) {
        const double near_plane = views[std::size_t(face)].camera.near_plane;
        EXPECT_GT(place_in(views[std::size_t(face)], dvec3(1)).z, -1) << face;
        EXPECT_LT(place_in(views[std::size_t(face)], dvec3(1)).z, -0.94) << face << near_plane;
    }
    // Straight ahead, what is farthest is as far as the farthest corner at most.
    EXPECT_LT(place_in(views[0], {std::sqrt(27.0), 0, 0}).z, 1);
    EXPECT_GT(place_in(views[0], {1.02 * std::sqrt(27.0), 0, 0}).z, 1);
}

TEST(LightViews, OfALightAmongTheBodiesBeginAtA4096thOfTheirReach) {
    scene::Light light = point_light(vec3(0));
    const scene::Bounds bounds{dvec3(-4, -1, -1), dvec3(4, 1, 1), false};
    const double reach = 1.01 * std::sqrt(18.0), nearest = reach / 4096;
    for (const bool spot : {false, true}) {
        if (spot) light.kind = scene::LightKind::Spot, light.direction = {1, 0, 0};
        const scene::View view = light_views(light, bounds, 64)[0];  // along +x
        const double near_plane = spot ? nearest : nearest * 0.57;
        EXPECT_NEAR(place_in(view, {near_plane, 0, 0}).z, -1, 1e-9);
        EXPECT_NEAR(place_in(view, {reach, 0, 0}).z, 1, 1e-9);
    }
}

/// A lamp's light lies on its face: edge-on it hides nothing, so depth need not reach to it.
TEST(LightViews, OfALightOnAFaceBeginAsIfItWereNotThere) {
    Case c;
    c.lamp({0, 3, 0});
    c.s.objects.push_back({.name = "lamp", .mesh = shape("rectangle", {})});
    const auto planes = [](const std::vector<scene::View>& views) {
        std::vector<double> planes;
        for (const scene::View& view : views) planes.push_back(view.camera.near_plane);
        return planes;
    };
    const auto of_bounds = [&] {
        return planes(light_views(c.s.lights[0], scene::bounds(c.s), 64));
    };
    c.s.objects.back().world_from_object[3] = dvec4(0, 3, 0, 1);
    EXPECT_EQ(planes(light_views(c.s.lights[0], c.s, 64)), of_bounds());
    c.s.objects.back().world_from_object[3] = dvec4(0, 2.9995, 0, 1);
    EXPECT_LT(planes(light_views(c.s.lights[0], c.s, 64))[3], of_bounds()[3]) << "downwards";
}

/// As wide as the cone and 2 % wider; at least a tenth of a degree.
TEST(LightViews, OfASpotAreAsWideAsItsCone) {
    scene::Light light = point_light({0, 0, 0});
    light.kind = scene::LightKind::Spot;
    light.direction = {0, 0, -1};
    const scene::Bounds bounds{dvec3(-1, -1, -9), dvec3(1, 1, -5), false};
    for (const double cone : {1.0, 30.0, 60.0}) {
        light.cone_angle = cone;
        const auto views = light_views(light, bounds, 64);
        ASSERT_EQ(views.size(), 1u);
        const double slope = std::tan(cone * std::acos(-1.0) / 180);
        EXPECT_NEAR(place_in(views[0], {7 * slope, 0, -7}).x, 1 / 1.02, 1e-9);
        EXPECT_NEAR(place_in(views[0], {0, -7 * slope, -7}).y, -1 / 1.02, 1e-9);
    }
    light.cone_angle = 0;
    EXPECT_LT(place_in(light_views(light, bounds, 64)[0], {0.01, 0, -7}).x, 1);
    light.cone_angle = 60.5;
    EXPECT_EQ(light_views(light, bounds, 64).size(), 6u);
}

TEST(LightViews, OfADirectionalLightHoldTheScene) {
    const scene::Light light{.direction = {0, -1, 0}};
    const auto views = light_views(light, {dvec3(-1, 0, -2), dvec3(3, 4, 2), false}, 64);
    ASSERT_EQ(views.size(), 1u);
    for (int i = 0; i < 8; ++i) {
        const dvec3 p =
            place_in(views[0], scene::corner({dvec3(-1, 0, -2), dvec3(3, 4, 2), false}, i));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(p[k]), 1 / 1.01, 1e-9);
    }
    EXPECT_LT(place_in(views[0], {0, 4, 0}).z, place_in(views[0], {0, 0, 0}).z) << "from above";
    // A floor without height has a box all the same.
    const auto flat = light_views(light, {dvec3(-1, 0, -2), dvec3(3, 0, 2), false}, 64);
    EXPECT_LT(std::abs(place_in(flat[0], {3, 0, 2}).z), 1);
}

TEST(ShadowMapSize, IsThePowerOfTwoTwiceTheWindow) {
    EXPECT_EQ(shadow_map_size(96, 72), 256);
    EXPECT_EQ(shadow_map_size(640, 480), 2048);
    EXPECT_EQ(shadow_map_size(4096, 4096), 4096);
}

TEST(WorldTriangles, MeetsThePolygonOfTheItemBuffer) {
    const Case c;
    const scene::View view = scene::make_view(c.s, window_width, window_height);
    const PassModel model = make_pass_model(c.s);
    const auto machine = make_reference(vgx(), window_width, window_height);
    const auto ids = scene::draw_item_buffer(*machine, *model.scene, view, {});
    const scene::WorldTriangles table(c.s);
    const scene::PixelRays rays_of(view);
    const std::size_t middle = std::size_t(window_height / 2 * window_width + window_width / 4);
    ASSERT_NE(ids[middle], 0u);
    const scene::PixelRay ray = rays_of.through(window_width / 4 + 0.5, window_height / 2 + 0.5);
    const auto at = table.meet(ids[middle], ray.o, ray.d);
    ASSERT_TRUE(at.has_value());
    EXPECT_NEAR(at->p.y, 0, 1e-12) << "a point of the floor";
    EXPECT_EQ(table.meet(0, ray.o, ray.d), std::nullopt);
    EXPECT_EQ(table.meet(1u << 30, ray.o, ray.d), std::nullopt);
}

}  // namespace
}  // namespace gw::multipass
