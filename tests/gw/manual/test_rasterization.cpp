// docs/manual/rasterization.md: the worked examples. test_worked_triangle.cpp has the planes of the
// worked triangle.
#include "gw/reference/plane_equation.h"
#include "gw/stages/perspective.h"
#include "tests/gw/workbench.h"

#include <cmath>
#include <utility>
#include <vector>

namespace gw {
namespace {

using test::Workbench;

// [R9.1] [R9.2]
TEST(ManualRasterization, EdgeFunctions) {
    const std::array<std::array<std::int64_t, 2>, 3> v{{{82, 28}, {561, 160}, {120, 486}}};
    const std::array<std::int64_t, 3> expected{54319, 127657, 32388};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = v[i], &b = v[(i + 1) % 3];
        const std::int64_t dx = b[0] - a[0], dy = b[1] - a[1];
        const bool top_left = dy < 0 || (dy == 0 && dx < 0);
        EXPECT_EQ(top_left, i == 2);
        EXPECT_EQ(dx * (164 - a[1]) - dy * (164 - a[0]) - (top_left ? 0 : 1), expected[i]);
    }
    Workbench bench(vgx(), 128, 64);
    bench.draw(Primitive::Triangles, {{10.25f, 3.5f, 0}, {70.125f, 20, 0}, {15, 60.75f, 0}});
    EXPECT_EQ(bench.color(20, 20)[3], 255);
}

// [R9.2]
TEST(ManualRasterization, CentresOnSidesBelongToLeftAndTopSides) {
    Workbench bench(vgx(), 8, 8);
    bench.draw(Primitive::Quads,
               {{1.5f, 1.5f, 0}, {4.5f, 1.5f, 0}, {4.5f, 4.5f, 0}, {1.5f, 4.5f, 0}});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(bench.color(x, y)[3] != 0, x >= 1 && x <= 3 && y >= 2 && y <= 4)
                << x << " " << y;
}

// [R9.3] [R9.4] [R9.5]
TEST(ManualRasterization, ALineAndAPoint) {
    Workbench bench(vgx(), 64, 64);
    bench.draw(Primitive::Lines, {{2, 2, 0}, {12, 7, 0}});
    const int rows[] = {2, 2, 3, 3, 4, 4, 5, 5, 6, 6};
    for (int i = 0; i < 10; ++i) EXPECT_EQ(bench.color(2 + i, rows[i])[3], 255) << i;
    EXPECT_EQ(bench.take_counters().fragments, 10u);

    bench.clear();
    bench.take_counters();
    bench.state.line_width = 3;
    bench.draw(Primitive::Lines, {{2, 2, 0}, {12, 7, 0}});
    for (int i = 0; i < 10; ++i)
        for (int k = -1; k <= 1; ++k) EXPECT_EQ(bench.color(2 + i, rows[i] + k)[3], 255) << i;
    EXPECT_EQ(bench.take_counters().fragments, 30u);

    bench.clear();
    bench.take_counters();
    bench.state.point_size = 3;
    bench.draw(Primitive::Points, {{40.5f, 40.5f, 0}});
    for (int y = 39; y <= 41; ++y)
        for (int x = 39; x <= 41; ++x) EXPECT_EQ(bench.color(x, y)[3], 255);
    EXPECT_EQ(bench.take_counters().fragments, 9u);
}

/// The pixels of one line by the diamond rule, as columns and rows.
std::vector<std::pair<int, int>> diamond_pixels(const vec3& from, const vec3& to) {
    Workbench bench(vgx(), 16, 16);
    bench.state.diamond_lines = true;
    bench.draw(Primitive::Lines, {from, to});
    std::vector<std::pair<int, int>> out;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            if (bench.color(x, y)[3] != 0) out.emplace_back(x, y);
    return out;
}

// [R9.34]
TEST(ManualRasterization, LinesByTheDiamondRule) {
    using Pixels = std::vector<std::pair<int, int>>;
    Pixels row;
    for (int x = 2; x <= 11; ++x) row.emplace_back(x, 5);
    EXPECT_EQ(diamond_pixels({2, 6, 0}, {12, 6, 0}), row);
    EXPECT_EQ(diamond_pixels({2.25f, 3.5f, 0}, {5.75f, 3.5f, 0}), (Pixels{{2, 3}, {3, 3}, {4, 3}}));
    EXPECT_EQ(diamond_pixels({5.75f, 3.5f, 0}, {2.25f, 3.5f, 0}), (Pixels{{3, 3}, {4, 3}, {5, 3}}));
    EXPECT_EQ(diamond_pixels({2.625f, 3.5f, 0}, {2.875f, 3.5f, 0}), Pixels{});
}

// [R9.6] [R9.8]
TEST(ManualRasterization, IncrementsEqualTheClosedForm) {
    // [L8]: z + dz/dx from pixel to pixel in both directions, with 16 fraction bits.
    using namespace reference;
    const SnappedTriangle t =
        snapped_triangle({{{82, 28, 0}, {561, 160, 0}, {120, 486, 0}}}, {}, 3);
    const PlaneEquation z = plane_through(t, {1000000, 5000000, 9000000});
    // n = (P1 - P0) x (P2 - P0) with the third coordinates in depth: -n_x / n_z is Gx / 2^19 per
    // unit.
    const double n_x = 132.0 * 8000000 - 4000000.0 * 458, n_z = 214366;
    EXPECT_LT(std::abs(-n_x / n_z * 8 * 65536 - double(std::int64_t(z.gx))), 0.5);

    const auto with_fraction = [&](int x, int y) {  // V before its last shift
        const std::int64_t px = x * 8 + 4, py = y * 8 + 4;
        return (std::int64_t{1000000} << 16) + (1 << 15) +
               ((std::int64_t(z.gx) * (px - 82) + std::int64_t(z.gy) * (py - 28)) >> 3);
    };
    std::int64_t v = with_fraction(20, 20);
    for (int x = 21; x <= 64; ++x) {
        v += std::int64_t(z.gx);
        EXPECT_EQ(v >> 16, z.at(x, 20));
    }
    EXPECT_EQ(v >> 16, 4905769);
    for (int y = 21; y <= 40; ++y) {
        v += std::int64_t(z.gy);
        EXPECT_EQ(v, with_fraction(64, y));
    }
}

// [R9.6]
TEST(ManualRasterization, GradientsAreToNearestAndTiesToEven) {
    for (const auto& [num, q] :
         {std::pair(-7, -4), {-5, -2}, {-3, -2}, {-1, 0}, {1, 0}, {3, 2}, {5, 2}, {7, 4}})
        EXPECT_EQ(int(divide_round_even(num, 2)), q) << num << " / 2";
    for (int num = -20; num <= 20; ++num)
        EXPECT_EQ(int(divide_round_even(num, 5)), int(std::lround(num / 5.0))) << num << " / 5";
}

// [R9.11] [R9.12]
TEST(ManualRasterization, PolygonOffset) {
    Workbench bench(reality(), 16, 16);
    bench.clear();
    const std::vector<vec3> square{{0, 0, 1000}, {16, 0, 2600}, {16, 16, 2600}, {0, 16, 1000}};
    bench.state.depth.test = true;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(5, 9), 1550u);
    bench.clear();
    bench.state.polygon_offset = {true, 1.5f, -3};
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(5, 9), 1550u + 147);
    // Clamped to the range of the plane. Outlines have no offset.
    bench.clear();
    bench.state.polygon_offset.units = -4000;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(5, 9), 0u);
    bench.clear();
    bench.state.polygon_mode = PolygonMode::Line;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(0, 4), 1000u);
}

// [R9.22]
TEST(ManualRasterization, OutlinesHaveTheOffsetOfTheirPolygon) {
    Workbench bench(opengl(), 16, 16);
    const std::vector<vec3> square{{0, 0, 1000}, {16, 0, 2600}, {16, 16, 2600}, {0, 16, 1000}};
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.state.polygon_mode = PolygonMode::Line;
    bench.state.polygon_offset = {.factor = 1.5f, .units = -3, .lines = true};
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(0, 4), 1000u + 147);
    bench.state.polygon_mode = PolygonMode::Point;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(0, 0), 1000u);
    bench.state.polygon_offset.points = true;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(0, 0), 1000u + 147);
    bench.draw(Primitive::Points, {{5.5f, 5.5f, 700}});
    EXPECT_EQ(bench.depth(5, 5), 700u);
}

/// The columns of row y that have fragments.
std::string row_of(Workbench& bench, int y, int width) {
    std::string out;
    for (int x = 0; x < width; ++x) out += bench.color(x, y)[3] != 0 ? '#' : '.';
    return out;
}

// [R9.20]
TEST(ManualRasterization, AStippledLine) {
    const auto row = [](Primitive primitive, const std::vector<vec3>& ends, int factor) {
        Workbench bench(opengl(), 24, 4);
        bench.state.line_stipple = {true, factor, 0x0013};  // steps 0, 1 and 4 of 16
        bench.draw(primitive, ends);
        return row_of(bench, 0, 24);
    };
    EXPECT_EQ(row(Primitive::Lines, {{0, 0.5f, 0}, {24, 0.5f, 0}}, 1), "##..#...........##..#...");
    EXPECT_EQ(row(Primitive::Lines, {{0, 0.5f, 0}, {24, 0.5f, 0}}, 2), "####....##..............");
    EXPECT_EQ(row(Primitive::Lines, {{24, 0.5f, 0}, {0, 0.5f, 0}}, 1), "...#..##...........#..##");
    // A strip goes on counting; Lines begin anew.
    const std::vector<vec3> strip{{0, 0.5f, 0}, {3, 0.5f, 0}, {8, 0.5f, 0}};
    EXPECT_EQ(row(Primitive::LineStrip, strip, 1), "##..#...................");
    EXPECT_EQ(row(Primitive::Lines, {strip[0], strip[1], strip[1], strip[2]}, 1),
              "##.##..#................");
}

// [R9.20]
TEST(ManualRasterization, AnOutlinesStippleGoesAroundItsPolygon) {
    Workbench bench(opengl(), 16, 16);
    bench.state.polygon_mode = PolygonMode::Line;
    bench.state.line_stipple = {true, 1, 0x5555};
    bench.draw(Primitive::Quads,
               {{0.5f, 0.5f, 0}, {3.5f, 0.5f, 0}, {3.5f, 3.5f, 0}, {0.5f, 3.5f, 0}});
    EXPECT_EQ(bench.take_counters().fragments, 6u);  // of 12 steps around
    EXPECT_EQ(row_of(bench, 0, 4), "#.#.");
    EXPECT_EQ(bench.color(3, 1)[3], 255);  // step 4: the second edge goes on
}

// [R9.21]
TEST(ManualRasterization, AStippledPolygon) {
    Workbench bench(opengl(), 40, 40);
    std::array<std::uint32_t, 32> rows{};
    rows[1] = 0xC0000001;
    bench.state.polygon_stipple.pattern =
        std::make_shared<const std::array<std::uint32_t, 32>>(rows);
    const std::vector<vec3> square{{0, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}};
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.take_counters().fragments, 10u);
    EXPECT_EQ(row_of(bench, 1, 40), "##.............................###......");
    EXPECT_EQ(row_of(bench, 33, 40), "##.............................###......");
    EXPECT_EQ(row_of(bench, 0, 40), std::string(40, '.'));
    bench.state.polygon_mode = PolygonMode::Point;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.color(0, 0)[3], 255);
}

// [R9.7] [R9.13] [R9.14] [R9.15]
TEST(ManualRasterization, HalfWayOnTheScreenIsAThirdOfTheWay) {
    using namespace reference;
    const std::array<double, 2> w{1, 2}, v{0, 1};
    const auto q = denominators(w);
    const Numerators u = numerators(v, w, 0);
    EXPECT_EQ(q[0], 1 << 30);
    EXPECT_EQ(q[1], 1 << 29);
    EXPECT_EQ(u.at[0], 0);
    EXPECT_EQ(u.at[1], 1 << 29);
    EXPECT_EQ(u.exponent, 0);
    // pixel centres 0.5 to 8.5: pixel 4 is half-way
    const SnappedLine line{{{4, 68}, {4, 4}}, true, 3};
    const float Q = float(plane_along(line, q[0], q[1]).at(4, 0));
    const float U = float(plane_along(line, u.at[0], u.at[1]).at(4, 0));
    EXPECT_EQ(Q, 0.75f * 0x1p30f);
    EXPECT_EQ(U, 0.25f * 0x1p30f);
    EXPECT_NEAR(U * (1 / Q), 1 / 3.0f, 6e-8f);
}

// [R9.13]
TEST(ManualRasterization, AtTheFarEndQIsAtLeastOne) {
    const std::array<double, 3> w{1e-9, 1, 1e12};
    EXPECT_EQ(denominators(w), (std::array<std::int64_t, 3>{1 << 30, 1, 1}));
}

}  // namespace
}  // namespace gw
