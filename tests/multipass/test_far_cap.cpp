// Far caps against points of the scene's bounds, in world space.
#include "multipass/shadow/far_cap.h"

#include "multipass/shadow/shadow_volume.h"
#include "scene/draw/view.h"
#include "tests/multipass/shadow_cases.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace gw::multipass {
namespace {

constexpr int steps = 24;

scene::Bounds room() { return {.low = {-6, 0, -6}, .high = {6, 5, 6}, .empty = false}; }

std::vector<scene::Light> lights() {
    std::vector<scene::Light> list;
    for (const vec3& p :
         {vec3(0, 4.5f, 0), vec3(-5, 4.8f, 5), vec3(5.5f, 0.3f, 0.1f), vec3(0.1f, 9, -2)})
        list.push_back({.kind = scene::LightKind::Point, .position = p});
    for (const vec3& d : {vec3(-0.5f, -1, -0.25f), vec3(1, -0.05f, 0.7f), vec3(0, -1, 0)})
        list.push_back({.direction = d});
    return list;
}

/// A body in the room, turned and of three sizes along its axes.
dmat4 placement() {
    dmat4 m(1);
    m[3] = dvec4(4, 1.4, -4.2, 1);
    return glm::scale(glm::rotate(m, 0.7, dvec3(0.3, 1, 0.2)), dvec3(1.5, 0.8, 1.1));
}

bool inside(const scene::Bounds& b, const dvec3& p) {
    return p.x >= b.low.x && p.x <= b.high.x && p.y >= b.low.y && p.y <= b.high.y &&
           p.z >= b.low.z && p.z <= b.high.z;
}

/// Points of the triangle a, b, c, its border among them, that lie in the bounds.
int points_inside(const scene::Bounds& bounds, const dvec3& a, const dvec3& b, const dvec3& c) {
    int count = 0;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
            count += inside(bounds, (double(i) * a + double(j) * b + double(steps - i - j) * c) /
                                        double(steps));
    return count;
}

/// The far cap of a body's every triangle in one light.
struct MovedBody {
    Topology t;
    LightInObject light;
    FarCap far;

    MovedBody(const MeshRef& mesh, const scene::Light& l, const dmat4& world_from_object)
        : t(topology(*mesh)), light(light_in_object(l, world_from_object, room())) {
        far = far_cap(t, light, std::vector<int>(t.triangles.size(), 1));
    }
    bool is_wide(const std::array<std::uint32_t, 3>& triangle) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (multipass::is_wide(light, dvec3(t.points[triangle[k]]),
                                   dvec3(t.points[triangle[(k + 1) % 3]])))
                return true;
        return false;
    }
};

TEST(FarCap, NoTriangleOfItTouchesTheScene) {
    const dmat4 m = placement();
    int compared = 0, moved_on = 0;
    for (const MeshRef& mesh :
         {box_mesh(), open_box_mesh(), wings_mesh(),
          shape("torus", {{"segments", 12}, {"sides", 8}}), shape("torus_knot", {})})
        for (const scene::Light& l : lights()) {
            const MovedBody body(mesh, l, m);
            for (const auto& triangle : body.t.triangles) {
                if (body.is_wide(triangle)) continue;
                dvec3 at[3];
                for (std::size_t k = 0; k < 3; ++k) {
                    const dvec4 p = m * dvec4(dvec3(body.far.moved[triangle[k]]), 1);
                    at[k] = dvec3(p);
                }
                ++compared;
                EXPECT_EQ(points_inside(room(), at[0], at[1], at[2]), 0);
            }
            moved_on += body.far.walls.count() > 1;
        }
    EXPECT_GT(compared, 5000);
    EXPECT_GT(moved_on, 10) << "else no cap left by more than one wall";
}

TEST(FarCap, IsCloseBehindTheScene) {
    scene::Light sun{.direction = {0, -1, 0}};
    dmat4 m(1);
    m[3].y = 2;
    const MovedBody body(box_mesh(), sun, m);
    // The diagonal is 17.69, the margin a hundredth of it; the body's origin is 2 over the floor.
    const double margin = 0.01 * std::sqrt(12.0 * 12 + 5 * 5 + 12 * 12);
    for (const vec3& p : body.far.moved) EXPECT_NEAR(double(p.y), -2 - margin, 1e-6);
    EXPECT_EQ(body.far.walls, WallsOfCap(1u << (1u << 2)))
        << "all of it below the floor, the third wall";
}

TEST(FarCap, GoesOnWhereItsCornersLeaveByTwoWalls) {
    // Two corners leave by the floor, the third by the wall at x = 6, and then by the floor too.
    const scene::Light sun{.direction = {1, -1, 0.6f}};
    const MeshRef mesh = mesh_of({{3, 1, -5}, {3, 1, -4}, {5.5f, 1, -5}}, {0, 1, 2});
    const MovedBody body(mesh, sun, dmat4(1));
    EXPECT_EQ(body.far.walls, WallsOfCap(1u << (1u << 2)))
        << "beyond the floor, the third wall, and no other";
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(double(body.far.moved[i].y), -body.light.margin, 1e-6);
    EXPECT_LT(body.far.moved[0].x, 6);
    EXPECT_GT(body.far.moved[2].x, 6);
}

TEST(FarCap, OfATriangleSeenUnderAWideAngleIsMovedByTheReach) {
    const scene::Light lamp{.kind = scene::LightKind::Point, .position = {0.2f, 1.1f, 0.2f}};
    const MeshRef mesh = mesh_of({{-2, 1, -2}, {2, 1, -2}, {0, 1, 2}}, {0, 1, 2});
    const MovedBody body(mesh, lamp, dmat4(1));
    EXPECT_TRUE(body.is_wide(body.t.triangles[0]));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(body.far.moved[i], moved_by_reach(body.light, dvec3(body.t.points[i])));
}

TEST(FarCap, WithoutWallsIsMovedByTheReach) {
    const Topology t = topology(*box_mesh());
    const LightInObject sun{.directional = true, .position = {0, -1, 0}, .reach = 10};
    const FarCap far = far_cap(t, sun, std::vector<int>(t.triangles.size(), 1));
    for (const vec3& p : far.moved) EXPECT_EQ(p.y, -10);
    EXPECT_EQ(far.walls, WallsOfCap(1));
}

/// A floor, a wall behind and one to the left, and a body between them.
Case corner_of_a_room(const MeshRef& caster) {
    Case c(caster, {-4.2, 1.3, -4.2});
    for (int k = 0; k < 3; ++k) c.s.objects[1].world_from_object[k][k] = 1.5;
    c.s.objects.push_back(
        {.name = "back",
         .mesh = mesh_of({{-6, 0, -6}, {6, 0, -6}, {6, 5, -6}, {-6, 5, -6}}, {0, 1, 2, 0, 2, 3})});
    c.s.objects.push_back(
        {.name = "left",
         .mesh = mesh_of({{-6, 0, 6}, {-6, 0, -6}, {-6, 5, -6}, {-6, 5, 6}}, {0, 1, 2, 0, 2, 3})});
    c.s.camera = scene::Camera{.eye = {-1.5, 3.6, -4.9}, .at = {-5.6, 0.9, -4.8}, .fov = 75};
    return c;
}

TEST(FarCap, ShadowsFallOverTheCornersOfARoom) {
    for (const MeshRef& mesh :
         {box_mesh(), open_box_mesh(), shape("torus", {{"segments", 12}, {"sides", 8}})})
        for (const vec3& lamp :
             {vec3(0, 0, 0), vec3(0, 4, 0), vec3(-1.5f, 3, -1.5f), vec3(5, 1, 3)}) {
            Case c = corner_of_a_room(mesh);
            if (lamp == vec3(0))
                c.s.lights[0].direction = {-1, -0.6f, -0.8f};
            else
                c.lamp(lamp);
            SCOPED_TRACE(lamp.x);
            expect_true(c.s);
        }
}

TEST(FarCap, SidesAreEnoughUnlessTheEyeIsBeyondTheSameWall) {
    const Topology t = topology(*box_mesh());
    const scene::Light lamp{.kind = scene::LightKind::Point, .position = {0, 4, 0}};
    const ShadowVolume volume = shadow_volume(t, light_in_object(lamp, dmat4(1), room()), false);
    const auto outside = [&](const dvec3& eye, const dvec3& at) {
        scene::Scene s;
        s.camera = scene::Camera{.eye = eye, .at = at, .near_plane = 0.1, .far_plane = 100};
        const scene::View view = scene::make_view(s, 16, 16);
        return is_outside(volume, view.eye_from_world, view);
    };
    EXPECT_TRUE(outside({0, 3, 9}, {0, 0, 0})) << "beyond another wall";
    EXPECT_FALSE(outside({0, -9, 0.1}, {0, 0, 0})) << "the far cap is before the scene";
}

}  // namespace
}  // namespace gw::multipass
