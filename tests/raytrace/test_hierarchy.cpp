// [L12] The hierarchy finds what asking every triangle finds, bit for bit, on every target; Embree
// agrees; and nothing leaks between neighbours.
#include "gw/fast/simd/simd_target.h"
#include "tests/raytrace/embree_scene.h"
#include "tests/raytrace/random_triangles.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace gw::raytrace {
namespace {

/// Runs a test on every target of this processor.
template <class Test>
void on_every_target(const Test& test) {
    for (const std::string& name : fast::simd_targets()) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(fast::use_simd_target(name));
        test();
    }
    fast::use_simd_target("");
}

/// Woop, Benthin, Wald 2013, one triangle, no vectors: the scalar twin.
std::optional<float> meet(const HierarchyRay& ray, const HierarchyTriangle& triangle) {
    const vec3& d = ray.direction;
    int kz = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(d[k]) > std::abs(d[kz])) kz = k;
    const int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    const float sx = d[kx] / d[kz], sy = d[ky] / d[kz], sz = 1.0f / d[kz];
    std::array<float, 3> x, y, z;
    for (std::size_t c = 0; c < 3; ++c) {
        const vec3 p = triangle.corner[c] - ray.origin;
        x[c] = p[kx] - sx * p[kz];
        y[c] = p[ky] - sy * p[kz];
        z[c] = sz * p[kz];
    }
    std::array<float, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        e[i] = x[k] * y[j] - y[k] * x[j];
    }
    for (std::size_t i = 0; i < 3 && (e[0] == 0 || e[1] == 0 || e[2] == 0); ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        e[i] = float(double(x[k]) * double(y[j]) - double(y[k]) * double(x[j]));
    }
    const bool below = e[0] < 0 || e[1] < 0 || e[2]<0, above = e[0]> 0 || e[1] > 0 || e[2] > 0;
    const float sum = (e[0] + e[1]) + e[2];
    if ((below && above) || sum == 0) return std::nullopt;
    const float t = ((e[0] * z[0] + e[1] * z[1]) + e[2] * z[2]) / sum;
    if (!(t > ray.low && t < ray.high) || triangle.number == ray.skip) return std::nullopt;
    return t;
}

HierarchyHit by_brute_force(const HierarchyRay& ray,
                            const std::vector<HierarchyTriangle>& triangles) {
    HierarchyHit best{0, no_triangle};
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (const auto t = meet(ray, triangles[i]);
            t && (best.triangle == no_triangle || *t < best.t))
            best = {*t, std::uint32_t(i)};
    return best;
}

void expect_same_hits(const std::vector<HierarchyTriangle>& triangles, std::uint32_t seed,
                      int rays) {
    const Hierarchy hierarchy(triangles);
    RandomRays random(seed);
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        HierarchyRay ray = random.ray(triangles);
        if (i % 5 == 0) ray.skip = std::uint32_t(i) % std::uint32_t(triangles.size());
        if (i % 7 == 0) ray.high = 0.5f, ray.low = 0.1f;
        const HierarchyHit expected = by_brute_force(ray, triangles);
        const auto found = hierarchy.nearest(ray);
        ASSERT_EQ(found.has_value(), expected.triangle != no_triangle) << "ray " << i;
        ASSERT_EQ(hierarchy.occluded(ray), found.has_value()) << "ray " << i;
        if (!found) continue;
        ++hits;
        ASSERT_EQ(found->triangle, expected.triangle) << "ray " << i;
        ASSERT_EQ(std::bit_cast<std::uint32_t>(found->t), std::bit_cast<std::uint32_t>(expected.t))
            << i;
    }
    EXPECT_GT(hits, rays / 20);
}

TEST(Hierarchy, FindsWhatAskingEveryTriangleFinds) {
    on_every_target([] {
        for (const std::size_t count : {1, 7, 8, 9, 100, 2000})
            expect_same_hits(RandomRays(unsigned(count)).triangles(count, count < 10 ? 1.0f : 0.3f),
                             17, 2000);
    });
}

TEST(Hierarchy, TakesTheFirstOfCoincidentTriangles) {
    std::vector<HierarchyTriangle> triangles = RandomRays(3).triangles(40, 0.8f);
    const std::vector<HierarchyTriangle> once = triangles;
    for (int i = 0; i < 3; ++i) triangles.insert(triangles.end(), once.begin(), once.end());
    on_every_target([&] { expect_same_hits(triangles, 5, 2000); });
}

TEST(Hierarchy, BearsPointsNeedlesAndThousandsInOnePlace) {
    RandomRays random(11);
    std::vector<HierarchyTriangle> triangles = random.triangles(100, 0.5f);
    for (std::uint32_t i = 0; i < 3000; ++i) triangles.push_back({{vec3(0), vec3(0), vec3(0)}, i});
    for (float s = 1; s > 1e-30f; s *= 0.5f)
        triangles.push_back({{vec3(s, 0, 0), vec3(2 * s, s, 0), vec3(2 * s, 0, s)}, 7});
    for (int i = 0; i < 100; ++i) {
        const vec3 p = random.point(1), q = random.point(1);
        triangles.push_back({{p, q, p + (q - p) * 0.5f}, 9});
    }
    expect_same_hits(triangles, 6, 500);
}

TEST(Hierarchy, IsTheSameTreeForAnyNumberOfThreads) {
    const auto triangles = RandomRays(9).triangles(60000, 0.02f);
    const WideTree one = Hierarchy(triangles, 1).tree(), many = Hierarchy(triangles, 7).tree();
    ASSERT_EQ(one.nodes.size(), many.nodes.size());
    ASSERT_EQ(one.packets.size(), many.packets.size());
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
        for (int c = 0; c < width_of_tree; ++c) {
            ASSERT_EQ(one.nodes[i].child[c], many.nodes[i].child[c]);
            if (one.nodes[i].child[c] == 0) continue;
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_EQ(one.nodes[i].bound[axis][0][c], many.nodes[i].bound[axis][0][c]);
        }
    for (std::size_t i = 0; i < one.packets.size(); ++i)
        for (int k = 0; k < width_of_tree; ++k)
            ASSERT_EQ(one.packets[i].triangle[k], many.packets[i].triangle[k]);
}

TEST(Hierarchy, OfNothingMeetsNothing) {
    const Hierarchy none;
    EXPECT_FALSE(none.nearest({{0, 0, 0}, 0, {0, 0, 1}, 1e30f}));
    EXPECT_FALSE(none.occluded({{0, 0, 0}, 0, {0, 0, 1}, 1e30f}));
}

/// A net of points moved at random, triangles between neighbours: whatever is aimed at a corner or
/// a side of it hits, but for its border, which a silhouette may hide.
TEST(Hierarchy, LeaksNowhereBetweenNeighbours) {
    constexpr int n = 40;
    RandomRays random(21);
    std::vector<vec3> points;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            points.push_back(vec3(float(i - n / 2), float(j - n / 2), 8.0f) + random.point(0.4f));
    std::vector<HierarchyTriangle> net;
    const auto at = [&](int i, int j) { return points[std::size_t(j * (n + 1) + i)]; };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            net.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, 0});
            net.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, 0});
        }
    on_every_target([&] {
        const Hierarchy hierarchy(net);
        for (int j = 4; j < n - 4; ++j)
            for (int i = 4; i < n - 4; ++i) {
                const vec3 sideways[] = {at(i, j), (at(i, j) + at(i + 1, j)) * 0.5f,
                                         (at(i, j) + at(i + 1, j + 1)) * 0.5f};
                for (const vec3& p : sideways)  // exactly to corners and sides
                    EXPECT_TRUE(hierarchy.nearest({vec3(0), 0, p, 1e30f})) << i << " " << j;
            }
    });
}

TEST(Hierarchy, AgreesWithEmbree) {
    const auto triangles = RandomRays(30).triangles(5000, 0.2f);
    const Hierarchy hierarchy(triangles);
    const EmbreeScene embree(triangles);
    RandomRays random(31);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const HierarchyRay ray{random.point(2), 0, random.point(1), 1e30f};
        const HierarchyHit theirs = embree.nearest(ray);
        const auto ours = hierarchy.nearest(ray);
        ASSERT_EQ(ours.has_value(), theirs.triangle != no_triangle) << i;
        if (!ours) continue;
        ++hits;
        EXPECT_EQ(ours->triangle, theirs.triangle) << i;
        EXPECT_NEAR(ours->t, theirs.t, 1e-4f * (1 + theirs.t)) << i;
    }
    EXPECT_GT(hits, 5000);
}

}  // namespace
}  // namespace gw::raytrace
