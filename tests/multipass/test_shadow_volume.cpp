// Shadow volumes against rays: every pixel more than one away from an edge of the true shadow.
#include "multipass/shadow/shadow_volume.h"

#include "gw/error.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/catalogue.h"
#include "multipass/shadow/shadow_passes.h"
#include "multipass/shadow/shadows.h"
#include "tests/multipass/shadow_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::multipass {
namespace {

TEST(ShadowVolume, OfAClosedBodyInTheSun) { expect_true(Case().s); }
TEST(ShadowVolume, OfAClosedBodyByALamp) { expect_true(Case().lamp({1.5f, 3, 1}).s); }
TEST(ShadowVolume, OfAnOpenMesh) {
    expect_true(Case(open_box_mesh()).s);
    expect_true(Case(open_box_mesh()).lamp({1.5f, 3, 1}).s);
}
TEST(ShadowVolume, OfANonManifoldMesh) {
    expect_true(Case(wings_mesh()).s);
    expect_true(Case(wings_mesh()).lamp({1.5f, 3, 1}).s);
}
TEST(ShadowVolume, OfABodyTurnedInsideOutByItsTransform) {
    Case c;
    c.s.objects[1].world_from_object[0].x = -2;
    expect_true(c.s);
    c.lamp({1.5f, 3, 1});
    expect_true(c.s);
}
TEST(ShadowVolume, OnEveryProfile) {
    for (const Profile& profile : profiles()) expect_true(Case().lamp({1.5f, 3, 1}).s, profile);
}

TEST(ShadowVolume, WithTheEyeInsideIt) {
    Case c(box_mesh(), {0, 3, 0});
    c.s.objects[1].world_from_object[0].x = c.s.objects[1].world_from_object[2].z = 4;
    c.s.lights[0].direction = {0, -1, 0};
    c.s.camera = scene::Camera{.eye = {0.5, 1.5, 1.5}, .at = {0, 0, -1}, .fov = 70};
    expect_true(c.s, vgx(), 1000);
    c.lamp({0, 6, 0});
    expect_true(c.s, vgx(), 1000);
}
TEST(ShadowVolume, CutByTheNearPlane) {
    Case c(box_mesh(), {0, 3, 0});
    c.s.lights[0].direction = {0, -1, 0};
    // The near plane lies across the volume: the eye is outside, part of the near rectangle inside.
    c.s.camera = scene::Camera{.eye = {0, 2, 2.5}, .at = {0, 0, 0}, .fov = 60, .near_plane = 2.2};
    expect_true(c.s);
    c.s.camera->near_plane = 2.6;
    expect_true(c.s);
}
TEST(ShadowVolume, CutByTheFarPlane) {
    Case c;
    // Seen along the light's way, so that the volume leaves through the far plane, which is close
    // behind the floor's edge.
    c.s.lights[0].direction = {-1, -0.4f, 0};
    c.s.camera = scene::Camera{.eye = {4, 7, 0.5}, .at = {-2, 0, 0}, .fov = 50};
    expect_true(c.s);
    c.s.camera->far_plane = 10.5;
    expect_true(c.s, vgx(), 30);
}
TEST(ShadowVolume, LeavesThePicturesOwnFarPlane) {
    Case c;
    c.s.background = vec3(0, 0, 1);
    c.s.camera->far_plane = 7;
    const scene::View view = scene::make_view(c.s, window_width, window_height);
    const auto is_background = [&](scene::Shadow shadow) {
        c.s.lights[0].shadow = shadow;
        const auto machine = make_reference(vgx(), window_width, window_height);
        render(*machine, c.s, view, {});
        std::vector<bool> result;
        for (const Rgba& color : machine->planes().color)
            result.push_back(color == Rgba{0, 0, 255, 255});
        return result;
    };
    const auto without = is_background(scene::Shadow::None);
    EXPECT_GT(std::count(without.begin(), without.end(), true), 1000);
    EXPECT_GT(std::count(without.begin(), without.end(), false), 1000);
    EXPECT_EQ(is_background(scene::Shadow::Volume), without);
}

TEST(ShadowVolume, OfALargeTriangleCloseToTheLamp) {
    // The lamp is close over a large square, near its border: it sees the square under nearly 180
    // degrees.
    Case c(mesh_of({{-2, 0, -2}, {2, 0, -2}, {2, 0, 2}, {-2, 0, 2}}, {0, 2, 1, 0, 3, 2}),
           {-1, 1, 0});
    c.lamp({0.99f, 1.01f, 0.1f});
    c.s.camera = scene::Camera{.eye = {5, 2.5, 5}, .at = {0, 0.3, 0}, .fov = 50};
    expect_true(c.s);
}
TEST(ShadowVolume, OfALampInsideTheBody) {
    Case c(box_mesh(2), {0, 2.5, 0});
    c.lamp({0.2f, 2.5f, 0.1f});
    expect_true(c.s);
}
TEST(ShadowVolume, OfCurvedBodies) {
    for (const char* name : {"sphere", "torus"}) {
        const MeshRef mesh =
            shape(name, {{"slices", 12}, {"stacks", 8}, {"segments", 12}, {"sides", 8}});
        EXPECT_TRUE(topology(*mesh).closed) << name;
        expect_true(Case(mesh).s);
        expect_true(Case(mesh).lamp({1.5f, 3, 1}).s);
    }
}

TEST(ShadowVolume, CountedOneByOneGivesTheSameShadow) {
    const Case c;
    const scene::View view = scene::make_view(c.s, window_width, window_height);
    const PassModel model = make_pass_model(c.s);
    Shadows shadows = find_volumes(model, topologies(model));
    const PlacedModel placed = place_model(model, enclosing(view, model, shadows));
    const auto stencil = [&](const CountRules& rules) {
        const auto machine = make_reference(vgx(), window_width, window_height);
        CommandList list = frame_list(c.s, view, {depth_pass}, vec3(0));
        add_shadow_volumes(list, placed, "shadow", shadows.volumes[0], rules);
        machine->execute(list);
        EXPECT_FALSE(any_overflow(machine->passes()));
        return machine->planes().stencil;
    };
    auto counts = stencil({8, false, false});
    EXPECT_GT(*std::max_element(counts.begin(), counts.end()), 0);
    for (auto& count : counts) count = std::min<std::uint8_t>(count, 1);
    EXPECT_EQ(stencil({8, true, false}), counts);
    EXPECT_EQ(stencil({8, false, true}), counts);
}

TEST(ShadowVolume, TooDeepForTheStencilIsCountedOneByOne) {
    // Six plates over one another, on a machine that counts to three.
    Case c(mesh_of({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {0, 2, 1, 0, 3, 2}));
    for (int i = 1; i < 6; ++i) {
        c.s.objects.push_back(c.s.objects[1]);
        c.s.objects.back().world_from_object[3].y += 0.1 * i;
    }
    Profile profile = vgx();
    profile.stencil_bits = 2;
    expect_true(c.s, profile);
    profile.stencil_bits = 1;
    EXPECT_THROW(expect_true(Case(wings_mesh()).s, profile), Error)
        << "wings over wings: one volume is too deep";
}

TEST(ShadowVolume, FrontCapHasThePositionsOfTheMesh) {
    const MeshRef mesh = box_mesh();
    const ShadowVolume volume = shadow_volume(
        topology(*mesh), {.directional = true, .position = {0, -1, 0}, .reach = 10}, false);
    // Two triangles of the lid, as many below, four sides of two.
    EXPECT_EQ(volume.caps->triangles().size(), 2u + 2u);
    EXPECT_EQ(volume.sides->triangles().size(), 8u);
    for (const MeshRef& part : {volume.caps, volume.sides}) {
        int on_lid = 0, far = 0;
        for (const vec3& p : part->data().positions) {
            on_lid += p.y == 0.5f;
            far += p.y == -10;
        }
        EXPECT_EQ(on_lid, 4);
        EXPECT_EQ(far, 4);
    }
}

/// The stencil plane of a frame's shadow, counted in front where that is allowed or behind
/// everywhere.
std::vector<std::uint8_t> shadow_stencil(const scene::Scene& s, bool in_front,
                                         std::size_t* outside = nullptr) {
    const PassModel model = make_pass_model(s);
    const Shadows shadows = find_volumes(model, topologies(model));
    const scene::View view =
        enclosing(scene::make_view(s, window_width, window_height), model, shadows);
    const PlacedModel placed = place_model(model, view);
    CommandList list = frame_list(s, view, {depth_pass}, vec3(0));
    add_shadow_volumes(list, placed, "shadow", shadows.volumes[0], {.in_front = in_front});
    for (std::size_t i = 0; outside && i < model.parts.size(); ++i)
        *outside += shadows.volumes[0][i].caps &&
                    is_outside(shadows.volumes[0][i], placed.eye_from_object[i], view);
    const auto machine = make_reference(vgx(), window_width, window_height);
    machine->execute(list);
    return machine->planes().stencil;
}

TEST(ShadowVolume, CountedInFrontIsCountedBehind) {
    std::size_t outside = 0, in_shadow = 0;
    for (const MeshRef& mesh :
         {box_mesh(), open_box_mesh(), wings_mesh(),
          shape("torus", {{"segments", 12}, {"sides", 8}}), shape("torus_knot", {})})
        for (const vec3& lamp :
             {vec3(0, 0, 0), vec3(1.5f, 3, 1), vec3(-4, 0.75f, 2), vec3(0.2f, 9, -3)}) {
            Case c(mesh);
            if (lamp != vec3(0)) c.lamp(lamp);
            // Background above the floor, and in front of the far cap.
            c.s.camera = scene::Camera{.eye = {-5, 1.5, 6}, .at = {0, 1, 0}, .fov = 50};
            const auto behind = shadow_stencil(c.s, false);
            EXPECT_EQ(shadow_stencil(c.s, true, &outside), behind) << lamp.x;
            in_shadow += std::size_t(
                std::count_if(behind.begin(), behind.end(), [](int n) { return n > 0; }));
        }
    EXPECT_GT(in_shadow, 1000u);
    EXPECT_GT(outside, 10u) << "else nothing was counted in front";
}

TEST(ShadowVolume, SidesAreEnoughForAnEyeThatSeesAllOfItFromThisSideOfItsFarCap) {
    const ShadowVolume lamp =
        shadow_volume(topology(*box_mesh()), {.position = {0, 4, 0}, .reach = 10}, false);
    const auto outside = [&](const dvec3& eye, const dvec3& at) {
        scene::Scene s;
        s.camera = scene::Camera{.eye = eye, .at = at, .near_plane = 0.1, .far_plane = 100};
        const scene::View view = scene::make_view(s, 16, 16);
        return is_outside(lamp, view.eye_from_world, view);
    };
    EXPECT_TRUE(outside({0, 3, 8}, {0, 0, 0}));
    EXPECT_FALSE(outside({0, -1, 0.1}, {0, -1, -5})) << "inside";
    EXPECT_FALSE(outside({3, -1, 0}, {3, -1, -5}))
        << "beside it, but half of it is behind the near plane";
    EXPECT_FALSE(outside({0, -30, 0.1}, {0, 0, 0})) << "the far cap is before the scene";
}

TEST(Topology, ClosedMeansBalanced) {
    EXPECT_TRUE(topology(*box_mesh()).closed);
    EXPECT_FALSE(topology(*open_box_mesh()).closed);
    EXPECT_FALSE(topology(*wings_mesh()).closed);
    EXPECT_EQ(topology(*box_mesh()).edges.size(), 18u);
}

TEST(Topology, WeldsVerticesThatDifferInNormalsOnly) {
    MeshData data = box_mesh()->data(), split{};
    for (const std::uint32_t i : data.indices) split.positions.push_back(data.positions[i]);
    const Topology t = topology(*make_mesh(split));
    EXPECT_EQ(t.points.size(), 8u);
    EXPECT_TRUE(t.closed);
}

}  // namespace
}  // namespace gw::multipass
