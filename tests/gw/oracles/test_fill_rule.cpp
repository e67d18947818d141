// A pixel of adjacent primitives belongs to exactly one of them. Random triangulations of a square,
// fans, strips and polylines are drawn with blending that adds 1, and every pixel must be 1.
// docs/manual/rasterization.md, "Coverage".
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>

namespace gw {
namespace {

using namespace test;

constexpr int size = 32;
using Corners = std::array<std::uint32_t, 3>;

/// A triangulation: points on the sub-pixel grid and counter-clockwise triangles.
struct Mesh2 {
    std::vector<GridPoint> points;
    std::vector<Corners> triangles;

    GridTriangle at(const Corners& t) const { return {points[t[0]], points[t[1]], points[t[2]]}; }
};

/// Splits the triangle that contains `p`, or the two on whose common side it lies. Does nothing
/// where `p` is a point of the triangulation.
void insert(Mesh2& m, const GridPoint& p) {
    if (std::find(m.points.begin(), m.points.end(), p) != m.points.end()) return;
    const auto index = std::uint32_t(m.points.size());
    m.points.push_back(p);
    std::vector<Corners> result;
    for (const Corners& t : m.triangles) {
        const GridTriangle g = m.at(t);
        const std::array<Int, 3> side{cross(g[0], g[1], p), cross(g[1], g[2], p),
                                      cross(g[2], g[0], p)};
        if (side[0] < 0 || side[1] < 0 || side[2] < 0) {
            result.push_back(t);
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i)
            if (side[i] > 0) result.push_back({t[i], t[(i + 1) % 3], index});
    }
    m.triangles = result;
}

/// Flips the common side of two triangles that form a strictly convex quadrilateral.
void flip(Mesh2& m, Corners& a, Corners& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            if (a[i] != b[(j + 1) % 3] || a[(i + 1) % 3] != b[j]) continue;
            const std::uint32_t p = a[i], q = a[(i + 1) % 3], far_a = a[(i + 2) % 3],
                                far_b = b[(j + 2) % 3];
            const Corners first{far_a, p, far_b}, second{far_b, q, far_a};
            const GridTriangle g = m.at(first), h = m.at(second);
            if (cross(g[0], g[1], g[2]) <= 0 || cross(h[0], h[1], h[2]) <= 0) return;
            a = first;
            b = second;
            return;
        }
}

Mesh2 triangulated_square(Random& random, int s) {
    const std::int64_t one = std::int64_t{1} << s, side = size * one;
    Mesh2 m{{{0, 0}, {side, 0}, {side, side}, {0, side}}, {{0, 1, 2}, {0, 2, 3}}};
    const auto coordinate = [&] {
        return random.one_in(2) ? random.between(0, 2 * size) * one / 2 : random.between(0, side);
    };
    for (int i = 0; i < 24; ++i) insert(m, {coordinate(), coordinate()});
    for (int i = 0; i < 200; ++i) {
        const auto a = std::size_t(random.between(0, std::int64_t(m.triangles.size()) - 1));
        const auto b = std::size_t(random.between(0, std::int64_t(m.triangles.size()) - 1));
        if (a != b) flip(m, m.triangles[a], m.triangles[b]);
    }
    return m;
}

MeshData mesh_of(const Mesh2& m, Random& random, int s) {
    MeshData data;
    const auto scale = float(1 << s);
    for (const GridPoint& p : m.points)
        data.positions.push_back({float(p.x) / scale, float(p.y) / scale, 0});
    for (Corners t : m.triangles) {
        std::rotate(t.begin(), t.begin() + random.between(0, 2), t.end());
        if (random.one_in(2)) std::swap(t[0], t[1]);
        data.indices.insert(data.indices.end(), t.begin(), t.end());
    }
    return data;
}

/// Adds 1 to each pixel covered.
void add_one(Workbench& bench) {
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    bench.state.color_mask = {true, false, false, false};
}
vec4 one_unit(const Profile& p) { return {1 / float((1 << p.color_bits) - 1), 0, 0, 0}; }

// [R9.2]
TEST(FillRule, ATriangulatedSquareCoversEachPixelOnce) {
    int triangles = 0;
    for (const Profile& profile : profiles())
        for (int i = 0; i < 150 && !HasFailure(); ++i) {
            SCOPED_TRACE(testing::Message() << profile.name << ", case " << i);
            Random random(std::uint64_t(i) + 1000);
            const int s = profile.subpixel_bits;
            const Mesh2 m = triangulated_square(random, s);
            MeshData data = mesh_of(m, random, s);
            data.colors.assign(data.positions.size(), one_unit(profile));
            triangles += int(m.triangles.size());

            Workbench bench(profile, size, size);
            add_one(bench);
            // A left side owns the centres on it, a lower side does not.
            bench.state.jitter = {int(random.between(0, 1 << s) - 1),
                                  int(random.between(0, 1 << s) - 1)};
            const int x0 = bench.state.jitter.x > (1 << s) / 2 ? 1 : 0;
            const int y0 = bench.state.jitter.y >= (1 << s) / 2 ? 1 : 0;
            bench.draw(data);
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    ASSERT_EQ(int(bench.color(x, y)[0]), x >= x0 && y >= y0 ? 1 : 0)
                        << x << " " << y;
        }
    RecordProperty("triangles", triangles);
}

/// A square of fat triangles: a displaced grid of 6 pixels with random diagonals. Cuts make slivers
/// only along the cut. The snap may turn a sliver over; then pixels near it have two owners or
/// none.
MeshData shaken_grid(Random& random) {
    MeshData data;
    constexpr int n = 6;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const auto shake = [&](int k) {
                return k == 0 || k == n ? 0 : float(random.between(-12, 12)) / 8;
            };
            data.positions.push_back({float(6 * i) - 2 + shake(i), float(6 * j) - 2 + shake(j), 0});
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            const bool rising = random.one_in(2);
            for (const std::uint32_t k :
                 rising ? std::array{a, b, c, a, c, d} : std::array{a, b, d, b, c, d})
                data.indices.push_back(k);
        }
    data.colors.assign(data.positions.size(), one_unit(vgx()));
    return data;
}

// [R6.26]
TEST(FillRule, BothSidesOfAUserPlaneCoverEachPixelOnce) {
    // Cut triangles are snapped again. Where the snap crosses two sides of a sliver, a pixel may
    // have two owners: two pixels in these 3000 pictures with about 60000 cuts.
    int twice = 0, none = 0;
    for (int i = 0; i < 3000; ++i) {
        Random random(std::uint64_t(i) + 5000);
        const MeshData data = shaken_grid(random);
        Workbench bench(vgx(), size, size);
        add_one(bench);
        const double a = double(random.between(-9, 9)) + 0.5, b = double(random.between(-9, 9));
        const double c = -(a + b) * double(random.between(8, 24));
        bench.state.clip_planes[2] = {true, {a, b, 0, c}};
        bench.draw(data);
        bench.state.clip_planes[2] = {true, {-a, -b, 0, -c}};
        bench.draw(data);
        for (const Rgba& color : bench.planes().color) {
            twice += color[0] > 1;
            none += color[0] == 0;
        }
    }
    EXPECT_EQ(twice, 2);
    EXPECT_EQ(none, 0);
}

TEST(FillRule, APolylineCoversEachColumnOnce) {
    for (const Profile& profile : profiles())
        for (int i = 0; i < 200 && !HasFailure(); ++i) {
            SCOPED_TRACE(testing::Message() << profile.name << ", case " << i);
            Random random(std::uint64_t(i) + 9000);
            const int s = profile.subpixel_bits;
            const std::int64_t one = std::int64_t{1} << s;
            // x-major, from the left to the right border.
            std::vector<vec3> points;
            std::int64_t x = 0, y = size * one / 2;
            while (true) {
                points.push_back({float(x) / float(one), float(y) / float(one), 0});
                if (x == size * one) break;
                const std::int64_t dx = std::min(random.between(1, 5 * one), size * one - x);
                x += dx;
                y += random.between(-dx, dx);
            }
            if (random.one_in(2)) std::reverse(points.begin(), points.end());
            Workbench bench(profile, size, 4 * size);
            add_one(bench);
            bench.state.viewport = {0, size, size, 2 * size};
            bench.state.projection = window_projection(profile, size, 2 * size);
            bench.draw(Primitive::LineStrip, points,
                       std::vector<vec4>(points.size(), one_unit(profile)));
            if (bench.take_counters().fragments == size)
                for (int c = 0; c < size; ++c) {
                    int sum = 0;
                    for (int r = 0; r < 4 * size; ++r) sum += bench.color(c, r)[0];
                    ASSERT_EQ(sum, 1) << c;
                }
        }
}

TEST(FillRule, AClosedOutlineHasNoPixelTwiceAndNoGap) {
    // The outline of a rectangle with corners on pixel centres: the last point of each side belongs
    // to the next side.
    for (int w = 1; w < 20; ++w)
        for (int h = 1; h < 10; ++h) {
            Workbench bench(vgx(), size, size);
            add_one(bench);
            bench.state.polygon_mode = PolygonMode::Line;
            const float x = 3.5f, y = 4.5f;
            bench.draw(Primitive::Quads,
                       {{x, y, 0},
                        {x + float(w), y, 0},
                        {x + float(w), y + float(h), 0},
                        {x, y + float(h), 0}},
                       std::vector<vec4>(4, one_unit(vgx())));
            EXPECT_EQ(bench.take_counters().fragments, 2u * unsigned(w + h));
            for (const Rgba& c : bench.planes().color) ASSERT_LE(c[0], 1);
        }
}

TEST(FillRule, SharedSidesOfTwoPolygonsAreTheSameLine) {
    // One polygon draws the side upwards, its neighbour downwards: the rows agree except at the
    // ends.
    for (int i = 0; i < 300; ++i) {
        Random random(std::uint64_t(i) + 300);
        const auto c = [&] { return float(random.between(0, 8 * size)) / 8; };
        const vec3 a(c(), c(), 0), b(c(), c(), 0);
        Workbench there(vgx(), size, size), back(vgx(), size, size);
        there.draw(Primitive::Lines, {a, b});
        back.draw(Primitive::Lines, {b, a});
        int different = 0;
        for (std::size_t k = 0; k < there.planes().color.size(); ++k)
            different += there.planes().color[k] != back.planes().color[k];
        EXPECT_LE(different, 2) << i;
    }
}

}  // namespace
}  // namespace gw
