// Checks that the triangles of a polygon cover it once, in integers. Does not make polygons.
#pragma once

#include "gw/mesh/orient.h"
#include "gw/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace gw::test {

using Polygon = std::vector<vec2>;

inline long twice_area(vec2 a, vec2 b, vec2 c) {
    const auto i = [](float v) { return static_cast<long>(v); };
    return (i(b.x) - i(a.x)) * (i(c.y) - i(a.y)) - (i(b.y) - i(a.y)) * (i(c.x) - i(a.x));
}

inline long twice_area(const Polygon& p) {
    long sum = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += twice_area(p[0], p[i], p[i + 1]);
    return sum;
}

inline std::array<vec2, 3> corners(const Polygon& p, const PolygonTriangle& t) {
    return {p[t.corner[0]], p[t.corner[1]], p[t.corner[2]]};
}

/// Counter-clockwise open triangles are disjoint exactly if a side of one has the other on its right
/// or on itself.
inline bool apart(const std::array<vec2, 3>& a, const std::array<vec2, 3>& b) {
    const auto beyond = [](const std::array<vec2, 3>& s, const std::array<vec2, 3>& t) {
        for (unsigned k = 0; k < 3; ++k) {
            bool right = true;
            for (const vec2& q : t) right = right && orient(s[k], s[(k + 1) % 3], q) <= 0;
            if (right) return true;
        }
        return false;
    };
    return beyond(a, b) || beyond(b, a);
}

inline int flat_triangles(const Polygon& p, const std::vector<PolygonTriangle>& triangles) {
    int flat = 0;
    for (const auto& t : triangles)
        flat += twice_area(p[t.corner[0]], p[t.corner[1]], p[t.corner[2]]) == 0;
    return flat;
}

/// The claims for a polygon of integers that does not cross itself: its triangles cover it once, with
/// `flat` of them without area.
inline void expect_cover(const Polygon& p, int flat) {
    const auto triangles = triangulate(p);
    ASSERT_EQ(triangles.size(), p.size() - 2);
    EXPECT_EQ(flat_triangles(p, triangles), flat);
    long sum = 0;
    std::set<std::uint32_t> used;
    std::vector<int> sides(p.size(), 0);
    for (const auto& t : triangles) {
        const auto c = corners(p, t);
        const long area = twice_area(c[0], c[1], c[2]);
        EXPECT_GE(area, 0) << "a triangle is turned over";
        sum += area;
        for (unsigned k = 0; k < 3; ++k) {
            used.insert(t.corner[k]);
            const bool side = (t.corner[k] + 1) % p.size() == t.corner[(k + 1) % 3];
            EXPECT_EQ((t.edges >> k & 1) != 0, side);
            if (side) ++sides[t.corner[k]];
        }
    }
    EXPECT_EQ(sum, twice_area(p));
    EXPECT_EQ(used.size(), p.size());
    EXPECT_EQ(sides, std::vector<int>(p.size(), 1))
        << "every side of the polygon is a side of one triangle";
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size(); ++j) {
            const auto a = corners(p, triangles[i]), b = corners(p, triangles[j]);
            if (twice_area(a[0], a[1], a[2]) == 0 || twice_area(b[0], b[1], b[2]) == 0) continue;
            ASSERT_TRUE(apart(a, b)) << "triangles " << i << " and " << j;
        }
}

}  // namespace gw::test
