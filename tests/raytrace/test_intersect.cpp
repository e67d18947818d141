// [L9, L11]: the plane's parameter, the inside test with its corner cases, the nearest of all.
#include "raytrace/casting/intersect.h"

#include <gtest/gtest.h>

namespace gw::raytrace {

const std::vector<dvec2> diamond{{0, -2}, {2, 0}, {0, 2}, {-2, 0}};

TEST(InsideByCrossings, CountsACornerOnTheHalfLineOnce) {
    EXPECT_TRUE(inside_by_crossings({0, 0}, diamond));     // the half-line runs through (2, 0)
    EXPECT_FALSE(inside_by_crossings({-3, 0}, diamond));   // through (-2, 0) and (2, 0)
    EXPECT_FALSE(inside_by_crossings({-3, 2}, diamond));   // touches the top
    EXPECT_FALSE(inside_by_crossings({-3, -2}, diamond));  // touches the bottom
}

TEST(InsideByCrossings, OwnsLeftAndTopSidesOnly) {
    const std::vector<dvec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    EXPECT_TRUE(inside_by_crossings({0, 2}, square));
    EXPECT_TRUE(inside_by_crossings({2, 4}, square));
    EXPECT_FALSE(inside_by_crossings({4, 2}, square));
    EXPECT_FALSE(inside_by_crossings({2, 0}, square));
}

TEST(InsideByCrossings, KnowsConcavePolygons) {
    const std::vector<dvec2> u{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
    EXPECT_TRUE(inside_by_crossings({0.5, 3}, u));
    EXPECT_FALSE(inside_by_crossings({2, 3}, u));
    EXPECT_TRUE(inside_by_crossings({3.5, 3}, u));
}

TEST(Intersect, MeetsThePolygonInFrontOnly) {
    const auto square = plane_polygon({{-1, -1, -4}, {1, -1, -4}, {1, 1, -4}, {-1, 1, -4}});
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, -1}}, square), 4.0);
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, -2}}, square), 2.0);
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, 1}}, square), std::nullopt);  // behind
    EXPECT_EQ(intersect({{0, 0, 0}, {1, 0, 0}}, square), std::nullopt);  // parallel
    EXPECT_EQ(intersect({{2, 0, 0}, {0, 0, -1}}, square), std::nullopt);
}

TEST(NearestHit, TakesTheNearestAndOfTiesTheFirst) {
    const auto at = [](double z) {
        return plane_polygon({{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    };
    const std::vector<PlanePolygon> polygons{at(-5), at(-3), at(-3), at(-4)};
    const auto hit = nearest_hit({{0, 0, 0}, {0, 0, -1}}, polygons);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->polygon, 1u);
    EXPECT_EQ(hit->t, 3.0);
    EXPECT_FALSE(nearest_hit({{0, 0, 0}, {0, 0, 1}}, polygons));
}

}  // namespace gw::raytrace
