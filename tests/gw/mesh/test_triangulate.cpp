#include "tests/gw/mesh/polygon_cover.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace gw {
namespace {

using namespace test;

TEST(Triangulate, AConvexPolygonBecomesTheFanFromItsFirstCorner) {
    const Polygon octagon{{2, 0}, {4, 0}, {6, 2}, {6, 4}, {4, 6}, {2, 6}, {0, 4}, {0, 2}};
    const auto triangles = triangulate(octagon);
    ASSERT_EQ(triangles.size(), 6u);
    for (std::uint32_t i = 0; i < 6; ++i) {
        EXPECT_EQ(triangles[i].corner, (std::array<std::uint32_t, 3>{0, i + 1, i + 2}));
        EXPECT_EQ(triangles[i].edges, 2 + (i == 0 ? 1 : 0) + (i == 5 ? 4 : 0));
    }
    expect_cover(octagon, 0);
}

TEST(Triangulate, ATriangleKeepsItsOrderEvenClockwise) {
    const Polygon clockwise{{0, 0}, {0, 4}, {4, 0}};
    EXPECT_EQ(triangulate(clockwise), (std::vector<PolygonTriangle>{{{0, 1, 2}, 7}}));
}

TEST(Triangulate, ConcaveShapes) {
    // U
    expect_cover({{0, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 5}, {0, 5}}, 0);
    // star
    expect_cover({{0, 0}, {10, 4}, {20, 0}, {16, 10}, {20, 20}, {10, 16}, {0, 20}, {4, 10}}, 0);
    // dart
    expect_cover({{0, 0}, {4, 1}, {8, 0}, {4, 9}}, 0);
    expect_cover({{0, 0},
                  {9, 0},
                  {9, 9},
                  {0, 9},
                  {0, 3},
                  {6, 3},
                  {6, 6},
                  {3, 6},
                  {3, 5},
                  {5, 5},
                  {5, 4},
                  {1, 4},
                  {1, 8},
                  {8, 8},
                  {8, 1},
                  {0, 1}},
                 0);  // spiral
}

TEST(Triangulate, ACornerOnAStraightSideIsUsedByTrianglesWithArea) {
    expect_cover({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, 0);
    expect_cover({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}, 0);
    expect_cover({{0, 0}, {4, 0}, {8, 0}, {4, 4}}, 0);  // a triangle with a corner on one side,
    expect_cover({{0, 0}, {4, 0}, {8, 0}, {6, 2}, {4, 4}, {2, 2}}, 0);  // on all sides
}

TEST(Triangulate, AKeyholePolygonCoversItsRing) {
    // A square with a square hole. The bridge from (0,0) to (2,2) is walked twice.
    expect_cover({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}},
                 0);
    // A bridge with a corner on one of its two walks.
    expect_cover(
        {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {1, 1}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}},
        0);
    // Two holes.
    expect_cover({{0, 0},
                  {20, 0},
                  {20, 8},
                  {0, 8},
                  {0, 0},
                  {2, 2},
                  {2, 6},
                  {6, 6},
                  {6, 2},
                  {12, 2},
                  {12, 6},
                  {16, 6},
                  {16, 2},
                  {12, 2},
                  {6, 2},
                  {2, 2}},
                 0);
}

TEST(Triangulate, PolygonsThatTouchThemselves) {
    // Where the border runs through a point twice, corners remain there and become flat triangles.
    // a corner met by a later one
    expect_cover({{0, 0}, {4, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}, 2);
    // a corner that meets a side
    expect_cover({{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}, 1);
    // two corners back to back
    expect_cover({{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}, 2);
    // Two squares joined by a bar without width that is bent twice.
    expect_cover({{0, 0},
                  {2, 0},
                  {2, 2},
                  {4, 2},
                  {4, 4},
                  {6, 4},
                  {6, 6},
                  {8, 6},
                  {8, 8},
                  {6, 8},
                  {6, 6},
                  {6, 4},
                  {4, 4},
                  {4, 2},
                  {2, 2},
                  {0, 2}},
                 10);
}

TEST(Triangulate, SpikesAndRepeatedCornersBecomeFlatTriangles) {
    expect_cover({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}}, 1);
    expect_cover({{0, 0}, {4, 0}, {7, 0}, {4, 0}, {4, 4}, {0, 4}}, 2);
    expect_cover({{0, 0}, {4, 0}, {4, 4}, {4, 9}, {4, 4}, {0, 4}}, 2);
}

// [R7.4]
TEST(Triangulate, AnyInputGivesTwoTrianglesLessThanCorners) {
    // one point
    EXPECT_EQ(triangulate(Polygon(7, vec2(3, 3))).size(), 5u);
    // one line
    EXPECT_EQ(triangulate(Polygon{{0, 0}, {1, 1}, {2, 2}, {5, 5}, {3, 3}}).size(), 3u);
    // a bow tie
    EXPECT_EQ(triangulate(Polygon{{0, 0}, {4, 4}, {4, 0}, {0, 4}}).size(), 2u);
    // a pentagram
    EXPECT_EQ(triangulate(Polygon{{0, 9}, {5, -6}, {-8, 3}, {8, 3}, {-5, -6}}).size(), 3u);
}

// Random polygons that do not cross themselves: a walk round the origin at random distances, on
// integers.
TEST(Triangulate, RandomStarShapedPolygons) {
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        const int n = 4 + static_cast<int>(random() % 40);
        std::vector<std::pair<double, vec2>> around;
        std::set<double> angles;
        for (int i = 0; i < n; ++i) {
            const int x = static_cast<int>(random() % 41) - 20,
                      y = static_cast<int>(random() % 41) - 20;
            const double angle = std::atan2(y, x);
            if ((x != 0 || y != 0) && angles.insert(angle).second)
                around.push_back({angle, vec2(x, y)});
        }
        std::sort(around.begin(), around.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        Polygon p;
        for (const auto& [angle, point] : around) p.push_back(point);
        bool round_the_origin = p.size() > 3;
        for (std::size_t i = 0; i < p.size(); ++i)
            round_the_origin = round_the_origin && orient(vec2(0), p[i], p[(i + 1) % p.size()]) > 0;
        if (!round_the_origin) continue;
        SCOPED_TRACE("round " + std::to_string(round));
        expect_cover(p, 0);
    }
}

// Outlines of unions of random grid cells, with the interior to the left: simple polygons with many
// straight corners and right angles.
TEST(Triangulate, RandomOutlinesOnAGrid) {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        Polygon p{{0, 0}};
        const int columns = 2 + static_cast<int>(random() % 30);
        Polygon top;
        for (int x = 0; x < columns; ++x) {  // a skyline: heights above and below the middle
            const float low = -1.0f - static_cast<float>(random() % 4),
                        high = 1.0f + static_cast<float>(random() % 4);
            p.push_back({x, low}), p.push_back({x + 1, low});
            top.push_back({x, high}), top.push_back({x + 1, high});
        }
        p.insert(p.end(), top.rbegin(), top.rend());
        Polygon distinct;
        for (const vec2& q : p)
            if (distinct.empty() || distinct.back() != q) distinct.push_back(q);
        SCOPED_TRACE("round " + std::to_string(round));
        expect_cover(distinct, 0);
    }
}

// [R7.1]
TEST(Triangulate, KeepsTheOrientationOfAPolygonInSpace) {
    const std::vector<vec3> u{{0, 0, 1}, {0, 6, 1}, {0, 6, 6}, {0, 4, 6},
                              {0, 4, 3}, {0, 2, 3}, {0, 2, 6}, {0, 0, 6}};
    for (const auto& t : triangulate(u)) {
        const vec3 n = glm::cross(u[t.corner[1]] - u[t.corner[0]], u[t.corner[2]] - u[t.corner[0]]);
        EXPECT_GT(n.x, 0.0f);
    }
    const std::vector<vec3> reversed(u.rbegin(), u.rend());
    for (const auto& t : triangulate(reversed)) {
        const vec3 n = glm::cross(reversed[t.corner[1]] - reversed[t.corner[0]],
                                  reversed[t.corner[2]] - reversed[t.corner[0]]);
        EXPECT_LT(n.x, 0.0f);
    }
}

TEST(Triangulate, AFigureOfEightStandingUprightIsSeenFromItsSide) {
    // its Newell normal is 0
    const std::vector<vec3> eight{{0, 5, 0}, {4, 5, 4}, {4, 5, 0}, {0, 5, 4}};
    const std::vector<vec2> seen = project_polygon(eight);
    EXPECT_EQ(std::set<float>({seen[0].x, seen[1].x, seen[2].x, seen[3].x}).size(), 2u);
    EXPECT_EQ(std::set<float>({seen[0].y, seen[1].y, seen[2].y, seen[3].y}).size(), 2u);
}

}  // namespace
}  // namespace gw
