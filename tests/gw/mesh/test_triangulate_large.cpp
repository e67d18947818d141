// Polygons of 10^5 corners, each triangulated in under a second of processor time, which other load
// does not change. A wrong complexity takes minutes. The areas prove that the work was done.
#include "tests/gw/mesh/polygon_cover.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

namespace gw {
namespace {

using test::Polygon;
using test::twice_area;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Large : public testing::Test {
protected:
    static constexpr int n = 100000;
    static double seconds(const Polygon& p) {
        const double begin = processor_seconds();
        triangles = triangulate(p);
        const double spent = processor_seconds() - begin;
        EXPECT_EQ(triangles.size(), p.size() - 2);
        long sum = 0, turned = 0;
        for (const auto& t : triangles) {
            const long area = twice_area(p[t.corner[0]], p[t.corner[1]], p[t.corner[2]]);
            sum += area;
            turned += area < 0;
        }
        EXPECT_EQ(sum, twice_area(p));
        EXPECT_EQ(turned, 0);
        return spent;
    }
    static inline std::vector<PolygonTriangle> triangles;
};

constexpr double limit =
#ifdef NDEBUG
    1.0;
#else
    30.0;
#endif

TEST_F(Large, SlantedComb) {
    Polygon p;
    for (int i = 0; i < n / 2; ++i)
        p.push_back({2 * i, 0}), p.push_back({2 * i + 1000000, 1000000});
    p.push_back({n, -2}), p.push_back({0, -2});
    std::reverse(p.begin(), p.end());
    EXPECT_LT(seconds(p), limit);
}

TEST_F(Large, SquareSpiral) {
    Polygon inner, outer;
    int x = 0, y = 0;
    for (int i = 0; i < n / 2;
         ++i) {  // arms of length 4, 4, 8, 8, 12, ...; the outer wall runs 1 beside the inner
        const int length = 4 * (i / 2 + 1), direction = i % 4;
        const int dx = direction == 0   ? 1
                       : direction == 2 ? -1
                                        : 0,
                  dy = direction == 1   ? 1
                       : direction == 3 ? -1
                                        : 0;
        inner.push_back({x, y});
        const int px = direction == 0 || direction == 3 ? -1 : 1,
                  py = direction == 0 || direction == 1 ? -1 : 1;
        outer.push_back({x + px, y + py});
        x += dx * length;
        y += dy * length;
    }
    Polygon p(inner.rbegin(), inner.rend());
    p.insert(p.end(), outer.begin(), outer.end());
    EXPECT_LT(seconds(p), limit);
}

TEST_F(Large, RaggedCircle) {
    std::mt19937 random(3);
    Polygon p;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979 * i / n,
                     radius = 4000000 + static_cast<double>(random() % 4000000);
        p.push_back({std::floor(radius * std::cos(angle)), std::floor(radius * std::sin(angle))});
    }
    EXPECT_LT(seconds(p), limit);
}

TEST_F(Large, OneThatCrossesItselfEverywhere) {
    std::mt19937 random(5);
    Polygon p;
    for (int i = 0; i < n; ++i)
        p.push_back({static_cast<float>(random() % 1000), static_cast<float>(random() % 1000)});
    const double begin = processor_seconds();
    EXPECT_EQ(triangulate(p).size(), p.size() - 2);
    EXPECT_LT(processor_seconds() - begin, limit);
}

}  // namespace
}  // namespace gw
