// [L9 to L12]: spheres by the discriminant, three inside tests, and accelerations that find what
// brute force finds, with fewer tests.
#include "raytrace/casting/cast_picture.h"

#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

namespace gw::raytrace {
namespace {

TEST(Sphere, IsMetWhereItIsEntered) {
    const Sphere sphere{{0, 0, -5}, 2};
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, -1}}, sphere), 3.0);
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, -2}}, sphere), 1.5)
        << "t counts in lengths of the direction";
    EXPECT_EQ(intersect({{0, 0, -5}, {0, 0, -1}}, sphere), 2.0) << "from inside: where it is left";
    EXPECT_EQ(intersect({{0, 0, -8}, {0, 0, -1}}, sphere), std::nullopt) << "behind";
    EXPECT_EQ(intersect({{2, 0, 0}, {0, 0, -1}}, sphere), 5.0) << "touched: the discriminant is 0";
    EXPECT_EQ(intersect({{2.001, 0, 0}, {0, 0, -1}}, sphere), std::nullopt);
    EXPECT_EQ(normal_at(sphere, {0, 2, -5}), dvec3(0, 1, 0));
}

constexpr InsideTest all_tests[] = {InsideTest::Crossings, InsideTest::CrossProducts,
                                    InsideTest::Angles};

dvec2 random_point(std::mt19937& bits) {
    const auto number = [&] { return double(bits() >> 8) / double(1 << 24); };
    return {number() * 4 - 2, number() * 4 - 2};
}

TEST(InsideTests, AgreeOnConvexPolygons) {
    std::mt19937 bits(5);
    for (int sides = 3; sides < 12; ++sides) {
        std::vector<dvec2> corners;
        for (int i = 0; i < sides; ++i)
            corners.emplace_back(1.5 * std::cos(2 * M_PI * i / sides),
                                 1.2 * std::sin(2 * M_PI * i / sides));
        for (int turn = 0; turn < 2; ++turn) {
            int inside_all = 0;
            for (int i = 0; i < 2000; ++i) {
                const dvec2 p = random_point(bits);
                const bool first = inside(all_tests[0], p, corners);
                inside_all += first;
                for (const InsideTest test : all_tests)
                    ASSERT_EQ(inside(test, p, corners), first) << p.x << " " << p.y;
            }
            EXPECT_GT(inside_all, 200);
            std::reverse(corners.begin(), corners.end());  // clockwise
        }
    }
}

TEST(InsideTests, DifferOnConcavePolygonsAsDocumented) {
    const std::vector<dvec2> u{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
    const auto expect = [&](const dvec2& p, bool crossings, bool products, bool angles) {
        EXPECT_EQ(inside_by_crossings(p, u), crossings) << p.x;
        EXPECT_EQ(inside_by_cross_products(p, u), products) << p.x;
        EXPECT_EQ(inside_by_angles(p, u), angles) << p.x;
    };
    expect({0.5, 3}, true, false, true);  // in an arm, but outside its kernel, which is empty
    expect({3.5, 2}, true, false, true);  // the other arm
    expect({2, 0.5}, true, false, true);  // the bottom
    expect({2, 3}, false, false, false);  // between the arms
}

TEST(InsideTests, DifferOnPolygonsThatCrossThemselvesAsDocumented) {
    std::vector<dvec2> star;
    for (int i = 0; i < 5; ++i)
        star.emplace_back(std::sin(4 * M_PI * i / 5), std::cos(4 * M_PI * i / 5));
    const dvec2 middle(0, 0), tip(0, 0.7), outside(0.5, 0.8);
    EXPECT_FALSE(inside_by_crossings(middle, star)) << "wound around twice";
    EXPECT_TRUE(inside_by_cross_products(middle, star));
    EXPECT_TRUE(inside_by_angles(middle, star));
    EXPECT_TRUE(inside_by_crossings(tip, star)) << "once";
    EXPECT_FALSE(inside_by_cross_products(tip, star));
    EXPECT_TRUE(inside_by_angles(tip, star));
    for (const InsideTest test : all_tests) EXPECT_FALSE(inside(test, outside, star));
    // A figure of eight: its halves are wound around once each, in different senses.
    const std::vector<dvec2> eight{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}};
    EXPECT_TRUE(inside_by_crossings({0.5, 0}, eight));
    EXPECT_FALSE(inside_by_cross_products({0.5, 0}, eight));
    EXPECT_TRUE(inside_by_angles({0.5, 0}, eight));
}

/// How often the polygon winds about p, in integers; none: p lies on a side.
std::optional<int> winding_number(const dvec2& p, const std::vector<dvec2>& corners) {
    int winding = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 a = corners[i] - p, b = corners[(i + 1) % corners.size()] - p;
        const auto cross =
            std::int64_t(a.x) * std::int64_t(b.y) - std::int64_t(a.y) * std::int64_t(b.x);
        if (cross == 0 && a.x * b.x + a.y * b.y <= 0) return std::nullopt;
        if (a.y < 0 && b.y >= 0 && cross > 0) ++winding;
        if (a.y >= 0 && b.y < 0 && cross < 0) --winding;
    }
    return winding;
}

TEST(InsideTests, SayOfAnyPolygonWhatItsWindingNumberSays) {
    std::mt19937 bits(9);
    std::array<int, 4> seen{};  // winding 0, 1, 2, more
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<dvec2> corners;
        for (unsigned i = 0, n = 3 + bits() % 7; i < n; ++i)
            corners.emplace_back(bits() % 16, bits() % 16);
        for (int x = 0; x < 16; ++x)
            for (int y = 0; y < 16; ++y) {
                const dvec2 p(x, y);
                const auto winding = winding_number(p, corners);
                if (!winding) continue;
                ++seen[std::size_t(std::min(std::abs(*winding), 3))];
                ASSERT_EQ(inside_by_crossings(p, corners), *winding % 2 != 0) << trial;
                ASSERT_EQ(inside_by_angles(p, corners), *winding != 0) << trial;
                ASSERT_TRUE(!inside_by_cross_products(p, corners) || *winding != 0) << trial;
            }
    }
    EXPECT_GT(*std::min_element(seen.begin(), seen.begin() + 3), 200);
}

TEST(InsideTests, AreMadeOfWhatEachSideAdds) {
    std::mt19937 bits(10);
    for (int trial = 0; trial < 4000; ++trial) {
        std::vector<dvec2> corners;
        for (unsigned i = 0, n = 3 + bits() % 5; i < n; ++i)
            corners.emplace_back(bits() % 8, bits() % 8);
        const dvec2 p(bits() % 8, bits() % 8);
        int crossed = 0, left = 0, right = 0;
        double angle = 0;
        bool on_side = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            crossed += crosses(p, a, b);
            left += side_product(p, a, b) > 0;
            right += side_product(p, a, b) < 0;
            const auto seen = seen_angle(p, a, b);
            on_side = on_side || !seen;
            angle += seen.value_or(0);
        }
        ASSERT_EQ(inside_by_crossings(p, corners), crossed % 2 == 1) << trial;
        ASSERT_EQ(inside_by_cross_products(p, corners), (left > 0) != (right > 0)) << trial;
        ASSERT_EQ(inside_by_angles(p, corners), on_side || std::abs(angle) > 3) << trial;
    }
}

constexpr CastMethod methods[] = {CastMethod::BruteForce, CastMethod::BoundingVolumes,
                                  CastMethod::Hierarchy, CastMethod::Grid};

scene::Scene solids() {
    return scene::read_scene(std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "hidden" /
                             "solids.toml")
        .scene;
}

TEST(Casting, FindsTheSameByEveryMethod) {
    const std::vector<CastShape> shapes = cast_shapes(solids());
    ASSERT_GT(shapes.size(), 20u);
    std::vector<std::unique_ptr<RayCaster>> casters;
    for (const CastMethod method : methods) casters.push_back(make_caster(method, shapes));
    std::vector<CastCounts> counts(casters.size());
    std::mt19937 bits(3);
    const auto number = [&] { return double(bits() >> 8) / double(1 << 23) - 1; };
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        Ray ray{{6 * number(), 3 + 3 * number(), 6 * number()}, {}};
        // towards the middle
        ray.direction = dvec3(2 * number(), number(), 2 * number()) - ray.origin;
        if (i % 3 == 0) ray.direction[i % 2] = 0;
        const auto expected = casters[0]->nearest(ray, counts[0]);
        hits += expected.has_value();
        for (std::size_t k = 1; k < casters.size(); ++k)
            ASSERT_EQ(casters[k]->nearest(ray, counts[k]), expected)
                << "method " << k << ", ray " << i;
    }
    EXPECT_GT(hits, 500);
    EXPECT_EQ(counts[0].shapes, 4000 * shapes.size());
    EXPECT_LT(counts[1].shapes, counts[0].shapes);
    EXPECT_LT(counts[2].shapes, counts[1].shapes);
    EXPECT_LT(counts[3].shapes, counts[1].shapes);
    EXPECT_EQ(counts[0].boxes, 0u);
    EXPECT_GT(counts[2].boxes, 0u);
    EXPECT_GT(counts[3].voxels, 4000u / 4);
}

TEST(Casting, TellsWhatARayLooksInto) {
    const std::vector<CastShape> shapes = cast_shapes(solids());
    const Ray ray{{3, 3, 7}, {-3, -2.9, -7}};
    for (const CastMethod method : methods) {
        const auto caster = make_caster(method, shapes);
        CastCounts counts;
        ASSERT_TRUE(caster->nearest(ray, counts));
        const std::vector<CastVisit> visits = caster->visits(ray);
        if (method == CastMethod::BruteForce) {
            EXPECT_TRUE(visits.empty());
            continue;
        }
        std::size_t tested = 0;
        for (const CastVisit& visit : visits) {
            tested += visit.shapes;
            // A voxel lies on the ray; so does every box in which shapes are tested.
            const bool is_met = method == CastMethod::Grid || visit.shapes > 0;
            EXPECT_TRUE(!is_met || through(visit.box, ray));
        }
        EXPECT_EQ(visits.size(), counts.boxes + counts.voxels);
        EXPECT_EQ(tested, counts.shapes);
        EXPECT_GT(tested, 0u);
    }
}

TEST(Casting, TakesSphereMeshesForSpheres) {
    const scene::Scene fig9 =
        scene::read_scene(std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "fig9.toml").scene;
    std::vector<double> radii;
    for (const CastShape& s : cast_shapes(fig9))
        if (const auto* sphere = std::get_if<Sphere>(&s.shape)) radii.push_back(sphere->radius);
    ASSERT_EQ(radii.size(), 3u);
    EXPECT_NEAR(radii[0], 0.6, 1e-6);
    EXPECT_NEAR(radii[1], 0.64, 1e-6);
    EXPECT_NEAR(radii[2], 0.6, 1e-6);
}

TEST(Casting, DrawsTheSamePictureByEveryMethodOnAnyNumberOfThreads) {
    const scene::Scene scene = solids();
    const scene::View view = scene::make_view(scene, 80, 60);
    const std::vector<CastShape> shapes = cast_shapes(scene);
    const CastPicture first =
        cast_picture(*make_caster(methods[0], shapes), shapes, scene, view, 1);
    EXPECT_EQ(first.counts.rays, 80u * 60u);
    for (const CastMethod method : methods) {
        const auto caster = make_caster(method, shapes);
        const CastPicture one = cast_picture(*caster, shapes, scene, view, 1),
                          many = cast_picture(*caster, shapes, scene, view, 4);
        EXPECT_EQ(one.color, first.color);
        EXPECT_EQ(many.color, first.color);
        EXPECT_EQ(many.counts, one.counts);
        EXPECT_EQ(many.tests, one.tests);
    }
}

TEST(Casting, OfNothingMeetsNothing) {
    const std::vector<CastShape> none;
    for (const CastMethod method : methods) {
        CastCounts counts;
        EXPECT_FALSE(make_caster(method, none)->nearest({{0, 0, 0}, {0, 0, 1}}, counts));
        EXPECT_EQ(counts.all(), 0u);
    }
}

}  // namespace
}  // namespace gw::raytrace
