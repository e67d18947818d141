// Shadow maps against rays, and against shadow volumes.
#include "multipass/shadow/shadow_lookup.h"
#include "multipass/shadow/shadow_map.h"
#include "scene/draw/item_buffer.h"
#include "scene/draw/pixel_rays.h"

#include "tests/multipass/shadow_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    for (const Profile& profile : profiles()) expect_true(mapped(Case()), profile);
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
