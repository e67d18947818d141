// Random lines through the machine against OpenGL's diamond-exit rule in exact rational arithmetic:
// a pixel has a fragment if the line leaves the open diamond of its centre. Both ends are moved by
// (-e, -e^2). Shares nothing with the machine's rule, which decides by columns. [GL11] 3.4.1
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <array>

namespace gw {
namespace {

using namespace test;

constexpr int size = 24;
constexpr int fine = 40;  ///< e = 2^-20 sub-pixel, e^2 = 2^-40

struct FinePoint {
    Int x = 0, y = 0;  ///< in 2^-40 sub-pixel
};
FinePoint moved(const GridPoint& p) {
    return {(Int{p.x} << fine) - (Int{1} << (fine / 2)), (Int{p.y} << fine) - 1};
}

/// How far a point is inside each of the four sides of a diamond; > 0: inside.
std::array<Int, 4> inside(const FinePoint& p, const FinePoint& center, Int radius) {
    const Int x = p.x - center.x, y = p.y - center.y;
    return {radius - x - y, radius - x + y, radius + x - y, radius + x + y};
}
bool is_inside(const std::array<Int, 4>& sides) {
    return std::ranges::all_of(sides, [](Int v) { return v > 0; });
}

/// Whether the segment between two points has a point inside all sides: parameters t in [0, 1] with
/// f0 + t (f1 - f0) > 0 for each side.
bool meets(const std::array<Int, 4>& f0, const std::array<Int, 4>& f1) {
    Rational low{-1, 1}, high{2, 1};  // outside [0, 1]; both bounds are open
    const auto less = [](const Rational& a, const Rational& b) { return a.n * b.d < b.n * a.d; };
    for (std::size_t i = 0; i < 4; ++i) {
        const Int slope = f1[i] - f0[i];
        if (slope == 0 && f0[i] <= 0) return false;
        if (slope > 0 && less(low, {-f0[i], slope})) low = {-f0[i], slope};
        if (slope < 0 && less({f0[i], -slope}, high)) high = {f0[i], -slope};
    }
    return less(low, high) && less(low, {1, 1}) && less({0, 1}, high);
}

struct Ends {
    GridPoint from, to;
    int width = 1;
};

/// A line `width` pixels wide is one pixel's line moved by half of width - 1, repeated.
bool leaves_diamond(const Ends& line, int x, int y, std::int64_t one) {
    const bool steep = std::abs(line.to.y - line.from.y) > std::abs(line.to.x - line.from.x);
    const std::int64_t shift = (line.width - 1) * one / 2;
    GridPoint a = line.from, b = line.to;
    for (GridPoint* p : {&a, &b}) (steep ? p->x : p->y) -= shift;
    const FinePoint from = moved(a), to = moved(b);
    for (int k = 0; k < line.width; ++k) {
        const FinePoint center{Int{(steep ? x - k : x) * one + one / 2} << fine,
                               Int{(steep ? y : y - k) * one + one / 2} << fine};
        const Int radius = Int{one / 2} << fine;
        const auto f0 = inside(from, center, radius), f1 = inside(to, center, radius);
        if (meets(f0, f1) && !is_inside(f1)) return true;
    }
    return false;
}

Ends random_ends(Random& random, std::int64_t one) {
    const auto coordinate = [&] {
        if (random.one_in(3)) return random.between(0, 2 * size) * one / 2;
        return random.between(-2 * one, (size + 2) * one);
    };
    Ends l{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (random.one_in(3))
        l.to = {l.from.x + random.between(-12, 12), l.from.y + random.between(-12, 12)};
    if (random.one_in(6)) l.to.y = l.from.y;
    if (random.one_in(6)) l.to.x = l.from.x;
    if (random.one_in(6)) l.to.x = l.from.x + (l.to.y - l.from.y);
    if (random.one_in(6)) l.to.x = l.from.x - (l.to.y - l.from.y);
    l.width = int(random.one_in(2) ? 1 : random.between(2, 6));
    return l;
}

void check(const Profile& profile, std::uint64_t seed) {
    const std::int64_t one = std::int64_t{1} << profile.subpixel_bits;
    const auto position = [&](const GridPoint& p) {
        return vec3(float(p.x) / float(one), float(p.y) / float(one), 0);
    };
    int covered = 0;
    for (int i = 0; i < 3000 && !testing::Test::HasFailure(); ++i) {
        Random random(seed * 1000000 + std::uint64_t(i));
        const Ends line = random_ends(random, one);
        SCOPED_TRACE(testing::Message()
                     << profile.name << ", case " << i << ": (" << line.from.x << " " << line.from.y
                     << ") (" << line.to.x << " " << line.to.y << ") width " << line.width);
        Workbench bench(profile, size, size);
        bench.state.diamond_lines = true;
        bench.state.line_width = float(line.width);
        bench.draw(Primitive::Lines, {position(line.from), position(line.to)});
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool expected = leaves_diamond(line, x, y, one);
                ASSERT_EQ(bench.color(x, y)[3] != 0, expected) << x << " " << y;
                covered += expected;
            }
    }
    EXPECT_GT(covered, 3000 * 5);
}

TEST(DiamondOracle, Vgx) { check(vgx(), 1); }
TEST(DiamondOracle, Reality) { check(reality(), 2); }
TEST(DiamondOracle, Ideal) { check(ideal(), 3); }

// A strip of lines covers each pixel at most once where it goes on in one direction, and has no gaps:
// the pixel that one line leaves out at its end, the next one has at its start.
TEST(DiamondLines, OfAStripAreTheWholeLines) {
    for (int i = 0; i < 400; ++i) {
        Random random(std::uint64_t(i) + 9);
        const auto eighth = [&](int low, int high) { return float(random.between(low, high)) / 8; };
        const vec3 a{eighth(0, 64), eighth(0, 190), 0}, b{eighth(120, 190), eighth(0, 190), 0};
        Workbench whole(vgx(), size, size), parts(vgx(), size, size);
        for (Workbench* bench : {&whole, &parts}) bench->state.diamond_lines = true;
        // the middle is on the grid only if the sums are even
        const vec3 middle = (a + b) * 0.5f;
        if (middle * 8.0f != glm::floor(middle * 8.0f)) continue;
        whole.draw(Primitive::Lines, {a, b});
        parts.draw(Primitive::LineStrip, {a, middle, b});
        EXPECT_EQ(whole.planes(), parts.planes()) << i;
        EXPECT_EQ(whole.take_counters().fragments, parts.take_counters().fragments) << i;
    }
}

}  // namespace
}  // namespace gw
