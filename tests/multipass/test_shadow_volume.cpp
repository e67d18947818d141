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
#include <set>

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
    for (const Profile& profile : paper_profiles())
        expect_true(Case().lamp({1.5f, 3, 1}).s, profile);
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

/// The stencil plane of a frame's shadow.
std::vector<std::uint8_t> shadow_stencil(const scene::Scene& s, const CountRules& rules,
                                         std::size_t* outside = nullptr) {
    const PassModel model = make_pass_model(s);
    const Shadows shadows = find_volumes(model, topologies(model));
    const scene::View view =
        enclosing(scene::make_view(s, window_width, window_height), model, shadows);
    const PlacedModel placed = place_model(model, view);
    CommandList list = frame_list(s, view, {depth_pass}, vec3(0));
    add_shadow_volumes(list, placed, "shadow", shadows.volumes[0], rules);
    for (std::size_t i = 0; outside && i < model.parts.size(); ++i)
        *outside += shadows.volumes[0][i].caps &&
                    is_outside(shadows.volumes[0][i], placed.eye_from_object[i], view);
    const auto machine = make_reference(vgx(), window_width, window_height);
    machine->execute(list);
    EXPECT_FALSE(any_overflow(machine->passes()));
    return machine->planes().stencil;
}

/// Three plates over one another, the sun in the zenith, an eye that sees only the floor.
TEST(ShadowVolume, IsCountedAsOftenAsBodiesAreInTheWay) {
    Case c(mesh_of({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {0, 2, 1, 0, 3, 2}));
    for (int i = 1; i < 3; ++i) {
        c.s.objects.push_back(c.s.objects[1]);
        c.s.objects.back().world_from_object[3].y += 0.5 * i;
    }
    c.s.lights[0].direction = {0, -1, 0};
    c.s.camera = scene::Camera{.eye = {0, 1, 5}, .at = {0, 0, 0.5}, .fov = 16};
    std::set<int> counts;
    for (const int n : shadow_stencil(c.s, {})) counts.insert(n);
    EXPECT_EQ(counts, (std::set<int>{0, 3}));

    for (const CountRules& rules : {CountRules{.zero_or_one = true}, CountRules{.one_by_one = true},
                                    CountRules{.zero_or_one = true, .one_by_one = true},
                                    CountRules{.in_front = true, .zero_or_one = true}}) {
        auto expected = shadow_stencil(c.s, {});
        for (auto& n : expected) n = std::min<std::uint8_t>(n, 1);
        EXPECT_EQ(shadow_stencil(c.s, rules), expected) << rules.in_front << rules.one_by_one;
    }
}

/// The window's pixels that an overflow pass looks at appear where as many triangles as the largest
/// count are drawn, and not before.
TEST(ShadowVolume, LooksForOverflowWhereItCanOccur) {
    const Case c(box_mesh());
    const PassModel model = make_pass_model(c.s);
    const Shadows shadows = find_volumes(model, topologies(model));
    const scene::View view = scene::make_view(c.s, window_width, window_height);
    const PlacedModel placed = place_model(model, view);
    std::size_t triangles = 0;
    for (const ShadowVolume& volume : shadows.volumes[0])
        for (const MeshRef& mesh : {volume.caps, volume.sides})
            triangles += mesh ? mesh->triangles().size() : 0;
    EXPECT_EQ(triangles, 12u + 12 + 4 + 8) << "caps and sides of the box, of the floor";
    const auto looks = [&](int stencil_bits) {
        CommandList list;
        add_shadow_volumes(list, placed, "shadow", shadows.volumes[0],
                           {.stencil_bits = stencil_bits});
        return std::any_of(list.commands.begin(), list.commands.end(), [](const Command& command) {
            const auto* begin = std::get_if<BeginPass>(&command);
            return begin && begin->name == "shadow overflow";
        });
    };
    EXPECT_TRUE(looks(5)) << 31;
    EXPECT_FALSE(looks(6)) << 63;
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
            const auto behind = shadow_stencil(c.s, {});
            EXPECT_EQ(shadow_stencil(c.s, {.in_front = true}, &outside), behind) << lamp.x;
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
