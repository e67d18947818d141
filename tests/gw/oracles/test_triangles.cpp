// Random triangles through the machine against exact arithmetic: coverage, Z and colour of every
// pixel of the window, on the built-in profiles and a few others.
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>

namespace gw {
namespace {

using namespace test;

constexpr int size = 32;

struct Case {
    GridTriangle grid;
    std::array<std::int64_t, 3> depth{}, red{};
};

/// A corner coordinate in sub-pixel units: inside the window, on pixel centres, or far outside it.
std::int64_t coordinate(Random& random, int s) {
    const std::int64_t one = std::int64_t{1} << s;
    switch (random.between(0, 9)) {
        case 0: return random.between(-6144 * one, 10239 * one);
        case 1: return random.between(0, size - 1) * one + one / 2;
        case 2: return random.between(0, size) * one;
        case 3: return random.between(-size, 2 * size) * one / 2;
        default: return random.between(-4 * one, (size + 4) * one);
    }
}

/// Depths that are exact in float32.
std::int64_t depth_value(Random& random, int bits) {
    if (random.one_in(8)) return 0;
    const int shift = random.one_in(2) ? 0 : std::max(0, bits - 24);
    return std::int64_t(random.next() >> (64 - std::min(bits, 24))) << shift;
}

Case random_case(Random& random, const Profile& p) {
    Case c;
    for (std::size_t i = 0; i < 3; ++i) {
        c.grid[i] = {coordinate(random, p.subpixel_bits), coordinate(random, p.subpixel_bits)};
        if (i == 2 && random.one_in(4))  // a sliver along the first side
            c.grid[i] = {c.grid[0].x + (c.grid[1].x - c.grid[0].x) / 3 + random.between(-2, 2),
                         c.grid[0].y + (c.grid[1].y - c.grid[0].y) / 3 + random.between(-2, 2)};
        c.depth[i] = depth_value(random, p.depth_bits);
        c.red[i] = random.between(0, (1 << p.color_bits) - 1);
    }
    return c;
}

void draw(Workbench& bench, const Case& c) {
    const auto scale = float(1 << bench.profile().subpixel_bits);
    const double white = (1 << bench.profile().color_bits) - 1;
    std::vector<vec3> positions;
    std::vector<vec4> colors;
    for (std::size_t i = 0; i < 3; ++i) {
        positions.push_back(
            {float(c.grid[i].x) / scale, float(c.grid[i].y) / scale, float(c.depth[i])});
        colors.push_back({float(double(c.red[i]) / white), 0, 0, 1});
    }
    bench.draw(Primitive::Triangles, positions, colors);
}

/// |V - exact| <= 1/2 + 1/4 + 2^-12 unit, and V between the corners' values.
void expect_near(std::int64_t v, const Rational& exact, const std::array<std::int64_t, 3>& a) {
    const Int difference = (Int{v} * exact.d - exact.n) * 4096;
    ASSERT_LE(difference < 0 ? -difference : difference, exact.d * (3072 + 1));
    ASSERT_GE(v, *std::min_element(a.begin(), a.end()));
    ASSERT_LE(v, *std::max_element(a.begin(), a.end()));
}

/// Checks every pixel of the window. Returns the number of covered pixels.
int check_picture(Workbench& bench, const Case& c, std::uint32_t background) {
    const int s = bench.profile().subpixel_bits;
    const std::int64_t one = std::int64_t{1} << s;
    int covered = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const GridPoint p{x * one + one / 2, y * one + one / 2};
            const bool inside = covers(c.grid, p);
            EXPECT_EQ(bench.color(x, y)[3] != 0, inside) << x << " " << y;
            if (!inside) {
                EXPECT_EQ(bench.depth(x, y), background);
                continue;
            }
            ++covered;
            EXPECT_EQ(std::int64_t{bench.depth(x, y)}, manual_value(c.grid, c.depth, p, s));
            EXPECT_EQ(std::int64_t{bench.color(x, y)[0]}, manual_value(c.grid, c.red, p, s));
            expect_near(bench.depth(x, y), exact_value(c.grid, c.depth, p), c.depth);
            expect_near(bench.color(x, y)[0], exact_value(c.grid, c.red, p), c.red);
        }
    return covered;
}

void check_profile(Profile profile, int cases, std::uint64_t seed) {
    profile.perspective_color = false;
    const std::uint32_t background = 12345;
    int covered = 0;
    for (int i = 0; i < cases && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << profile.name << ", seed " << seed << ", case " << i);
        Random random(seed * 1000000 + std::uint64_t(i));
        const Case c = random_case(random, profile);
        Workbench bench(profile, size, size);
        bench.clear(all_planes, vec4(0),
                    double(background) / double((1ull << profile.depth_bits) - 1));
        bench.state.depth = {.test = true, .func = DepthFunc::Always};
        draw(bench, c);
        covered += check_picture(bench, c, background);
    }
    testing::Test::RecordProperty("covered", covered);
    EXPECT_GT(covered, cases * 20);
}

TEST(TriangleOracle, Vgx) { check_profile(vgx(), 3000, 1); }
TEST(TriangleOracle, Reality) { check_profile(reality(), 3000, 2); }
TEST(TriangleOracle, Ideal) { check_profile(ideal(), 3000, 3); }

TEST(TriangleOracle, OddProfiles) {
    check_profile({.name = "ten", .color_bits = 10, .depth_bits = 20, .subpixel_bits = 1}, 1000, 4);
    check_profile({.name = "least", .depth_bits = 16, .subpixel_bits = 2}, 1000, 5);
    check_profile({.name = "thirteen", .color_bits = 13, .depth_bits = 31, .subpixel_bits = 5},
                  1000, 6);
}

}  // namespace
}  // namespace gw
