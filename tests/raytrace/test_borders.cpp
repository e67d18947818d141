// [L9] Mirrors and shadow rays at borders: beside corners and sides, in concave edges, on slivers,
// at grazing angles.
#include "tests/raytrace/closed_body_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::raytrace {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr int paths = 2000;

/// Rays in bodies, whose edges are concave from inside: no mirror lets one out, and no light from
/// outside reaches one.
class Inside {
public:
    Inside(const scene::Scene& scene, std::uint32_t seed) : world_(scene, 1), random_(seed) {}

    std::uint64_t bounces = 0, lost = 0, lit = 0;

    /// Leaves a wall, then is reflected by all that it meets.
    void follow() {
        const Surface wall = random_.seen(world_, false);
        Ray ray{wall.start, random_.leaving(wall, false)};
        std::uint32_t from = wall.at.triangle;
        for (int bounce = 0; bounce < 20; ++bounce) {
            const auto at = world_.nearest(ray, inf, from);
            if (!at) {
                ++lost;
                return;
            }
            const Surface s = surface(world_.triangles(), *at, ray.direction, view_);
            if (s.front) {
                ++lost;
                return;
            }
            ++bounces;
            // On the side of the wall that is seen: a light behind it does not reach it anyway.
            lit += !world_.occluded({s.start, random_.leaving(s, false)}, 50, at->triangle);
            const double height = dot3(ray.direction, s.plane_normal);
            ray = {s.start, normalized(ray.direction - 2 * height * s.plane_normal)};
            from = at->triangle;
        }
    }

private:
    World world_;
    scene::View view_{.width = 1, .height = 1};
    SceneRays random_;
};

std::vector<ClosedBodyCase> single_bodies() {
    std::vector<ClosedBodyCase> cases(6);
    cases[0].name = "box";
    cases[0].bodies.add(scene::make_box({2, 1, 1.5}, 3), scene::rotation({1, 2, 3}, 40));
    cases[1].name = "flat box";
    cases[1].bodies.add(scene::make_box({3, 0.003, 2}, 2), scene::rotation({3, 1, 2}, 20));
    cases[2].name = "needle";
    cases[2].bodies.add(scene::make_cone(0.02, 3, 24, 1, true), scene::rotation({1, 1, 0}, 70));
    cases[3].name = "glass";
    cases[3].bodies.add(scene::make_cylinder(1, 2, 40, 4, true), scene::rotation({1, 0, 0}, 20));
    cases[4].name = "ball";
    cases[4].bodies.add(scene::make_icosphere(1, 3), scene::translation({3, 2, 1}));
    cases[5].name = "torus knot";
    cases[5].bodies.add(scene::make_torus_knot(2, 3, 1, 0.2, 96, 12));
    return cases;
}

TEST(Borders, LetNoRayOutOfAMirroredRoom) {
    for (const ClosedBodyCase& c : single_bodies()) {
        Inside inside(c.bodies.scene, 3);
        for (int i = 0; i < paths; ++i) inside.follow();
        EXPECT_GT(inside.bounces, std::uint64_t(paths)) << c.name;
        EXPECT_EQ(inside.lost, 0u) << c.name << ", of " << inside.bounces;
    }
}

TEST(Borders, LetNoLightIntoAClosedBody) {
    for (const ClosedBodyCase& c : single_bodies()) {
        Inside inside(c.bodies.scene, 4);
        for (int i = 0; i < paths; ++i) inside.follow();
        EXPECT_EQ(inside.lit, 0u) << c.name << ", of " << inside.bounces;
    }
}

/// No part of a convex body is before another: neither a mirror on it nor a shadow ray meets it
/// again, however flat it leaves.
TEST(Borders, OfAConvexBodyHideNothingOfIt) {
    auto cases = single_bodies();
    cases.pop_back();  // the knot
    for (const ClosedBodyCase& c : cases) {
        const World world(c.bodies.scene, 1);
        SceneRays random(5);
        std::uint64_t met = 0, shaded = 0;
        for (int i = 0; i < 20 * paths; ++i) {
            const Surface s = random.seen(world, true);
            const Ray ray{s.start, random.leaving(s, false)};
            met += world.nearest(ray, inf, s.at.triangle).has_value();
            shaded += world.occluded(ray, 50, s.at.triangle);
        }
        EXPECT_EQ(met, 0u) << c.name;
        EXPECT_EQ(shaded, 0u) << c.name;
    }
}

/// Two mirrors at a right angle send a ray back the way it came, also closely beside their edge:
/// it meets both, and leaves.
TEST(Borders, OfTwoMirrorsAtARightAngleSendRaysBack) {
    Bodies mirrors;
    mirrors.add({.primitive = Primitive::Quads,
                 .positions = {{0, 0, -20}, {20, 0, -20}, {20, 0, 20}, {0, 0, 20}}});
    mirrors.add({.primitive = Primitive::Quads,
                 .positions = {{0, 0, -20}, {0, 0, 20}, {0, 20, 20}, {0, 20, -20}}});
    const World world(mirrors.scene, 1);
    const scene::View view{.width = 1, .height = 1};
    SceneRays random(6);
    for (int i = 0; i < paths; ++i) {
        double beside = 1;
        for (auto k = random.bits() % 9; k > 0; --k) beside /= 10;
        const double angle = 0.1 + 1.3 * random.number();  // of the ray with the first mirror
        const dvec3 way = normalized(dvec3(-std::cos(angle), -std::sin(angle), 0.2));
        Ray ray{dvec3(beside * (0.1 + random.number()), 0, 0) - 0.5 * way, way};
        std::uint32_t from = no_triangle;
        for (int mirror = 0; mirror < 2; ++mirror) {
            const auto at = world.nearest(ray, inf, from);
            ASSERT_TRUE(at) << "mirror " << mirror << ", " << beside << " beside the edge";
            const Surface s = surface(world.triangles(), *at, ray.direction, view);
            const double height = dot3(ray.direction, s.plane_normal);
            ray = {s.start, ray.direction - 2 * height * s.plane_normal};
            from = at->triangle;
        }
        EXPECT_NEAR(ray.direction.x, -way.x, 1e-12);
        EXPECT_NEAR(ray.direction.y, -way.y, 1e-12);
        EXPECT_FALSE(world.nearest(ray, inf, from)) << beside << " beside the edge";
    }
}

}  // namespace
}  // namespace gw::raytrace
