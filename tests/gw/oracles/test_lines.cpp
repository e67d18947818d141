// Random lines and points through the machine against exact arithmetic: coverage, depth and colour.
// In each column (row) whose centre a line crosses, it covers the pixel centres c with v - width/2
// < c <= v + width/2. A point has the same rule in both directions.
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <cstdlib>

namespace gw {
namespace {

using namespace test;

constexpr int size = 32;

/// v - width/2 < c <= v + width/2 for v = n / d, d > 0. All in units, `one` to a pixel.
bool in_band(Int n, Int d, std::int64_t c, std::int64_t width, std::int64_t one) {
    const Int twice = 2 * (d * c - n);  // 2 d (c - v)
    return twice > -(d * width * one) && twice <= d * width * one;
}

struct Line {
    GridPoint from, to;
    std::array<std::int64_t, 2> depth{}, red{};
    int width = 1;
};

bool steep(const Line& l) { return std::abs(l.to.y - l.from.y) > std::abs(l.to.x - l.from.x); }
GridPoint turned(const GridPoint& p) { return {p.y, p.x}; }

/// For a line that is not steep.
bool line_covers(const Line& l, const GridPoint& p, std::int64_t one) {
    const std::int64_t dx = l.to.x - l.from.x;
    if (dx == 0) return false;
    const bool crossed = dx > 0 ? l.from.x <= p.x && p.x < l.to.x : l.to.x < p.x && p.x <= l.from.x;
    const Int sign = dx < 0 ? -1 : 1;
    const Int n = sign * (Int{l.from.y} * dx + Int{p.x - l.from.x} * (l.to.y - l.from.y));
    return crossed && in_band(n, sign * dx, p.y, l.width, one);
}

/// Along the major axis from the end with the smaller coordinate; for a line that is not steep.
std::int64_t line_value(const Line& l, const std::array<std::int64_t, 2>& a, const GridPoint& p,
                        int s) {
    const bool forward = l.to.x > l.from.x;
    const std::int64_t x0 = forward ? l.from.x : l.to.x, d = std::abs(l.to.x - l.from.x);
    const std::int64_t a0 = forward ? a[0] : a[1], a1 = forward ? a[1] : a[0];
    const Int g = nearest_even(Int{a1 - a0} * (Int{1} << (16 + s)), d);
    const Int move = floor_of(g * (p.x - x0), Int{1} << s);
    return std::int64_t(floor_of((Int{a0} << 16) + (1 << 15) + move, 1 << 16));
}

Line random_line(Random& random, const Profile& p) {
    const std::int64_t one = std::int64_t{1} << p.subpixel_bits;
    const auto coordinate = [&] {
        if (random.one_in(10)) return random.between(-6000 * one, 10000 * one);
        if (random.one_in(3)) return random.between(0, 2 * size) * one / 2;
        return random.between(-2 * one, (size + 2) * one);
    };
    Line l{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (random.one_in(6)) l.to.y = l.from.y;
    if (random.one_in(6)) l.to.x = l.from.x + (l.to.y - l.from.y);
    l.to.x = std::clamp(l.to.x, -6144 * one, 10239 * one);
    for (std::size_t i = 0; i < 2; ++i) {
        l.depth[i] = random.between(0, (1 << 16) - 1);
        l.red[i] = random.between(0, (1 << p.color_bits) - 1);
    }
    l.width = int(random.one_in(2) ? 1 : random.between(2, 7));
    return l;
}

void check_line(const Profile& profile, const Line& line, int& covered) {
    const int s = profile.subpixel_bits;
    const std::int64_t one = std::int64_t{1} << s;
    const double white = (1 << profile.color_bits) - 1;
    const auto position = [&](const GridPoint& p, std::int64_t z) {
        return vec3(float(p.x) / float(one), float(p.y) / float(one), float(z));
    };
    Workbench bench(profile, size, size);
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.state.line_width = float(line.width);
    bench.draw(Primitive::Lines,
               {position(line.from, line.depth[0]), position(line.to, line.depth[1])},
               {{float(double(line.red[0]) / white), 0, 0, 1},
                {float(double(line.red[1]) / white), 0, 0, 1}});

    Line major = line;
    if (steep(line)) {
        major.from = turned(line.from);
        major.to = turned(line.to);
    }
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const GridPoint center{x * one + one / 2, y * one + one / 2};
            const GridPoint p = steep(line) ? turned(center) : center;
            const bool inside = line_covers(major, p, one);
            ASSERT_EQ(bench.color(x, y)[3] != 0, inside) << x << " " << y;
            if (!inside) continue;
            ++covered;
            ASSERT_EQ(std::int64_t{bench.depth(x, y)}, line_value(major, line.depth, p, s));
            ASSERT_EQ(std::int64_t{bench.color(x, y)[0]}, line_value(major, line.red, p, s));
        }
}

void check_lines(Profile profile, std::uint64_t seed) {
    profile.perspective_color = false;
    int covered = 0;
    for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << profile.name << ", seed " << seed << ", case " << i);
        Random random(seed * 1000000 + std::uint64_t(i));
        check_line(profile, random_line(random, profile), covered);
    }
    testing::Test::RecordProperty("covered", covered);
    EXPECT_GT(covered, 2000 * 10);
}

TEST(LineOracle, Vgx) { check_lines(vgx(), 1); }
TEST(LineOracle, Reality) { check_lines(reality(), 2); }
TEST(LineOracle, Ideal) { check_lines(ideal(), 3); }

TEST(LineOracle, BothDirectionsChooseTheSameRows) {
    Random random(4);
    for (int i = 0; i < 500; ++i) {
        // Columns away from the ends: the last point is left out.
        const vec3 a(0.25f, float(random.between(0, 256)) / 8, 0),
            b(32, float(random.between(0, 256)) / 8, 0);
        Workbench there(vgx(), size, size), back(vgx(), size, size);
        there.draw(Primitive::Lines, {a, b});
        back.draw(Primitive::Lines, {b, a});
        EXPECT_EQ(there.planes(), back.planes()) << i;
    }
}

TEST(PointOracle, EveryProfileAndSize) {
    for (const Profile& profile : profiles())
        for (int i = 0; i < 1000 && !testing::Test::HasFailure(); ++i) {
            SCOPED_TRACE(testing::Message() << profile.name << ", case " << i);
            Random random(std::uint64_t(i) + 77);
            const std::int64_t one = std::int64_t{1} << profile.subpixel_bits;
            const GridPoint p{random.between(-4 * one, (size + 4) * one),
                              random.between(-4 * one, (size + 4) * one)};
            Workbench bench(profile, size, size);
            const int point_size = int(random.between(1, 9));
            bench.state.point_size = float(point_size);
            bench.draw(Primitive::Points, {{float(p.x) / float(one), float(p.y) / float(one), 0}});
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const bool inside = in_band(p.x, 1, x * one + one / 2, point_size, one) &&
                                        in_band(p.y, 1, y * one + one / 2, point_size, one);
                    ASSERT_EQ(bench.color(x, y)[3] != 0, inside) << x << " " << y;
                }
        }
}

}  // namespace
}  // namespace gw
