// docs/manual/polygons.md: its pseudo-code, transcribed, makes the machine's triangles.
#include "conformance/generate/random.h"
#include "gw/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <set>

namespace gw {
namespace {

using Corners = std::vector<vec2>;
using Corner3 = std::array<std::uint32_t, 3>;

/// [R7.2], for coordinates that are small multiples of 1/4: exact in double.
int orient(vec2 a, vec2 b, vec2 c) {
    const dvec2 u = dvec2(b) - dvec2(a), v = dvec2(c) - dvec2(a);
    const double area = u.x * v.y - u.y * v.x;
    return (area > 0) - (area < 0);
}

enum Cut { Ear, TouchingEar, Flat, Convex, Any };

/// The page, line by line.
struct Clipper {
    const Corners& q;
    std::uint32_t n = std::uint32_t(q.size()), head = 0, left = n;
    std::vector<std::uint32_t> next = std::vector<std::uint32_t>(n),
                               previous = std::vector<std::uint32_t>(n);
    std::vector<int> turn = std::vector<int>(n);
    std::vector<bool> gone = std::vector<bool>(n);
    std::set<std::uint32_t> reflex;
    std::vector<Corner3> triangles;

    void update_turn(std::uint32_t i) { turn[i] = orient(q[previous[i]], q[i], q[next[i]]); }

    // [R7.4]
    std::vector<Corner3> run() {
        for (std::uint32_t i = 0; i < n; ++i) {
            next[i] = (i + 1) % n;
            previous[i] = (i + n - 1) % n;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            update_turn(i);
            if (turn[i] <= 0) reflex.insert(i);
        }
        for (const Cut cut : {Ear, TouchingEar, Flat, Convex, Any}) {
            int passes = 0;
            while (left > 3 && passes < 8) {
                const std::uint32_t before = left;
                run_pass(cut);
                if (left == before) break;
                passes = left < before / 2 ? 1 : passes + 1;
            }
        }
        triangles.push_back({previous[head], head, next[head]});
        return triangles;
    }

    // [R7.5]
    void run_pass(Cut cut) {
        std::vector<std::uint32_t> queue;
        for (std::uint32_t i = 0, c = head; i < left; ++i, c = next[c]) queue.push_back(c);
        for (std::size_t i = 0; i < queue.size() && left > 3; ++i) {
            const std::uint32_t c = queue[i];
            const bool later = std::count(queue.begin() + std::ptrdiff_t(i) + 1, queue.end(), c);
            if (later || gone[c] || !may_cut(c, cut)) continue;
            const std::uint32_t p = previous[c], k = next[c];
            triangles.push_back({p, c, k});
            next[p] = k;
            previous[k] = p;
            reflex.erase(c);
            gone[c] = true;
            for (const std::uint32_t j : {p, k}) {
                update_turn(j);
                if (turn[j] > 0) reflex.erase(j);
            }
            head = k;
            --left;
            queue.push_back(p);
            queue.push_back(k);
        }
    }

    // [R7.6]
    bool may_cut(std::uint32_t c, Cut cut) const {
        if (cut == Any) return true;
        if (turn[c] == 0) return cut == Flat || cut == Convex;
        if (turn[c] < 0) return false;
        return cut == Convex || is_ear(c, cut == Ear);
    }
    bool is_ear(std::uint32_t c, bool strict) const {
        const std::array<vec2, 3> t{q[previous[c]], q[c], q[next[c]]};
        bool met = false;
        for (const std::uint32_t k : reflex) {
            if (k == previous[c] || k == c || k == next[c]) continue;
            if (in_the_way(t, k, strict)) return false;
            met = met || q[k] == q[c];
        }
        return !met || encloses(t);
    }

    // [R7.7]
    bool in_the_way(const std::array<vec2, 3>& t, std::uint32_t k, bool strict) const {
        const int a = orient(t[0], t[1], q[k]), b = orient(t[1], t[2], q[k]),
                  d = orient(t[2], t[0], q[k]);
        if (a < 0 || b < 0 || d < 0) return false;
        if (a > 0 && b > 0 && d > 0) return true;
        if (strict && d == 0 && a > 0 && b > 0) return true;
        return enters(t, q[k], q[previous[k]]) || enters(t, q[k], q[next[k]]);
    }
    static bool enters(const std::array<vec2, 3>& t, vec2 from, vec2 to) {
        for (unsigned i = 0; i < 3; ++i)
            if (from == t[i])
                return orient(t[i], t[(i + 1) % 3], to) > 0 && orient(t[(i + 2) % 3], t[i], to) > 0;
        for (unsigned i = 0; i < 3; ++i)
            if (orient(t[i], t[(i + 1) % 3], from) == 0)
                return orient(t[i], t[(i + 1) % 3], to) > 0;
        return false;
    }

    // [R7.8]
    bool encloses(const std::array<vec2, 3>& t) const {
        const dvec2 m = ((dvec2(t[0]) + dvec2(t[1])) + dvec2(t[2])) / 3.0;
        int winding = 0;
        for (std::uint32_t i = 0, k = head; i < left; ++i, k = next[k]) {
            const dvec2 a = dvec2(q[k]) - m, b = dvec2(q[next[k]]) - m;
            const double side = a.x * b.y - a.y * b.x;
            if (a.y <= 0 && b.y > 0 && side > 0) ++winding;
            if (b.y <= 0 && a.y > 0 && side < 0) --winding;
        }
        return winding > 0;
    }
};

bool rightward(vec2 a, vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// [R7.3]
bool is_fan(const Corners& q) {
    const std::size_t n = q.size();
    int changes = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const vec2 a = q[i], b = q[(i + 1) % n], c = q[(i + 2) % n];
        if (a == b || orient(a, b, c) < 0) return false;
        changes += rightward(a, b) != rightward(b, c);
    }
    for (std::size_t i = 1; i + 1 < n; ++i)
        if (orient(q[0], q[i], q[i + 1]) <= 0) return false;
    return changes == 2;
}

std::vector<Corner3> by_the_page(const Corners& q) {
    if (!is_fan(q)) return Clipper{q}.run();
    std::vector<Corner3> out;
    for (std::uint32_t i = 1; i + 1 < q.size(); ++i) out.push_back({0, i, i + 1});
    return out;
}

std::vector<Corner3> by_the_machine(const Corners& q) {
    std::vector<Corner3> out;
    for (const PolygonTriangle& t : triangulate(std::span<const vec2>(q))) out.push_back(t.corner);
    return out;
}

std::string text(const Corners& q) {
    std::string out;
    for (const vec2& p : q) out += std::to_string(p.x) + "," + std::to_string(p.y) + " ";
    return out;
}

// [R7.3] [R7.4] [R7.5] [R7.6] [R7.7] [R7.8]
TEST(ManualPolygons, ThePagesPseudoCodeMakesTheMachinesTriangles) {
    conformance::Random r(7);
    for (int i = 0; i < 30000; ++i) {
        Corners q;
        const int count = r.between(4, r.chance(5) ? 60 : 14), side = r.between(1, 8);
        for (int k = 0; k < count; ++k) {
            const float x = float(r.between(0, side));
            q.push_back({x, float(r.between(0, side)) / 4});
        }
        ASSERT_EQ(by_the_machine(q), by_the_page(q)) << text(q);
    }
}

TEST(ManualPolygons, ThePagesPseudoCodeMakesTheTrianglesOfSimplePolygons) {
    conformance::Random r(8);
    for (int i = 0; i < 3000; ++i) {  // combs: their sides touch, and do not cross
        Corners q;
        const int columns = r.between(2, 20);
        for (int k = 0; k <= columns; ++k) q.push_back({float(k), float(r.between(0, 3))});
        for (int k = columns; k >= 0; --k) q.push_back({float(k), float(r.between(3, 6))});
        ASSERT_EQ(by_the_machine(q), by_the_page(q)) << text(q);
    }
}

// [R7.9]
TEST(ManualPolygons, SixCornersWithTwoReflexOnes) {
    const Corners q{{0, 0}, {6, 0}, {6, 6}, {4, 2}, {2, 2}, {0, 6}};
    const std::vector<PolygonTriangle> expected{
        {{1, 2, 3}, 3}, {{4, 5, 0}, 3}, {{0, 1, 3}, 1}, {{0, 3, 4}, 2}};
    EXPECT_EQ(triangulate(std::span<const vec2>(q)), expected);
}

TEST(ManualPolygons, ABowTie) {
    const Corners q{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
    EXPECT_EQ(by_the_machine(q), (std::vector<Corner3>{{3, 0, 1}, {3, 1, 2}}));
}

// [R7.1]
TEST(ManualPolygons, ThePlaneIsThatOfTheLargestComponentOfTheNormal) {
    const Corners grid{{0, 0}, {6, 0}, {6, 6}, {4, 2}, {2, 2}, {0, 6}};
    const auto in_space = [&](int first, int second, bool backwards) {
        std::vector<vec3> out;
        for (const vec2& c : grid) {
            vec3 p(0);
            p[first] = c.x;
            p[second] = c.y;
            out.push_back(p);
        }
        if (backwards) std::reverse(out.begin(), out.end());
        return project_polygon(out);
    };
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(in_space((axis + 1) % 3, (axis + 2) % 3, false), grid);
        Corners mirrored;
        for (const vec2& c : grid) mirrored.insert(mirrored.begin(), {c.y, c.x});
        EXPECT_EQ(in_space((axis + 1) % 3, (axis + 2) % 3, true), mirrored);
    }
    // Equal components: z, then y. No normal: the terms' magnitudes decide.
    EXPECT_EQ(project_polygon(std::vector<vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
              (Corners{{1, 0}, {0, 1}, {0, 0}}));
    EXPECT_EQ(project_polygon(std::vector<vec3>{{0, 0, 0}, {0, 4, 4}, {0, 4, 0}, {0, 0, 4}}),
              (Corners{{0, 0}, {4, 4}, {4, 0}, {0, 4}}));
}

}  // namespace
}  // namespace gw
